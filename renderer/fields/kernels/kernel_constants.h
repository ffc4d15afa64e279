// The constants of a kernel, solved once when a blob is compiled. A kernel is φ(q), q = squared distance to the skeleton over
// squared radius; inner loops use v = scale · q instead, which saves them a multiplication:
//
//   quartic   φ = amplitude (1 − v)²                                  v = q/Q,   φ = 0 from v = 1
//   gaussian  φ = amplitude (e^{a−v} − cut (1 + support − v))         v = a q,   φ = 0 from v = support = aQ
//
// With the radius of the surface (RadiusMeaning::surface) every kernel has φ(1) = 1 and φ′(1) = −h:
//   quartic   Q = 1 + 2/h, amplitude = (1 + h/2)²: φ′(1) = −2 amplitude (1 − 1/Q)/Q = −h.
//   gaussian  the Gaussian less its tangent (in q) at the support's border, so that value and slope vanish there:
//             cut = e^{−a(Q−1)} = δ, a = h (1 − δ(1 + ln 1/δ)) / (1 − δ), Q = 1 + ln(1/δ)/a, amplitude = 1/(1 − δ(1 + ln 1/δ)).
// With POV-Ray's support radius: quartic with Q = 1 and amplitude 1 (Murakami's (1 − r²/R²)²).
// Sources: Blinn 1982; Murakami and Ichihara 1987; the tangent window is ours (docs/decisions.md).
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

/// Where the Gaussian is cut off, relative to its value at the surface: a tail below a thousandth of the threshold.
inline constexpr double kGaussianCut = 1e-3;

struct KernelConstants {
  scene::KernelShape shape = scene::KernelShape::quartic;
  double scale = 1;      ///< v = scale · q
  double support = 1;    ///< φ = 0 from here on, in v
  double amplitude = 1;
  double a = 0;          ///< gaussian: v at the surface; else 0
  double cut = 0;        ///< gaussian: e^{a − support}; else 0

  /// Where the support ends, in q.
  [[nodiscard]] double support_q() const { return support / scale; }
};

/// Precondition: hardness in (0, 500] (the interpreter has seen to it).
[[nodiscard]] KernelConstants kernel_constants(const scene::Kernel& kernel);

}  // namespace isl::render
