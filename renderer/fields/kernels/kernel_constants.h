// The constants of a kernel, solved once when a blob is compiled. A kernel is amplitude · φ(v), where v = scale · q and
// q is the squared distance to the skeleton over the squared radius. The file of each kernel defines its φ and solves
// for its constants.
//
// With the radius of the surface (RadiusMeaning::surface) every kernel has the value 1 and the slope −h (in q) at q
// = 1. With POV-Ray's support radius the only kernel is the quartic, with scale and amplitude 1 (Murakami's
// (1 − r²/R²)²).
#pragma once

#include "renderer/scene/database.h"

#include <optional>

namespace isl::render {

struct KernelConstants {
  scene::KernelShape shape = scene::KernelShape::quartic;
  bool is_convolved = false;  ///< the kernel is a window to integrate (convolutions/); φ is not defined
  bool is_sheet = false;      ///< φ is the profile of a convolved plane (cubic-inl.h, sheet_cauchy-inl.h)
  double scale = 1;           ///< v = scale · q
  double support = 1;         ///< the v from which on φ = 0
  double amplitude = 1;
  double a = 0;    ///< gaussian: v at the surface; cauchy, its window and its sheet: ε; else 0
  double cut = 0;  ///< gaussian: e^{a − support}; else 0

  /// q at the border of the support.
  [[nodiscard]] double support_q() const { return support / scale; }
};

/// Precondition: hardness in (0, 500], and the shape of a convolution or a sheet quartic or cauchy (the interpreter
/// checks it).
[[nodiscard]] KernelConstants kernel_constants(const scene::Kernel& kernel);

/// φ(v), without the amplitude; 0 beyond the support.
[[nodiscard]] double kernel_profile(const KernelConstants& constants, double v);

/// The v at which amplitude · φ(v) passes a threshold, bisected to neighbouring doubles: the last where it is above. φ
/// falls with v. Nothing if it is nowhere above.
[[nodiscard]] std::optional<double> passing_argument(const KernelConstants& constants, double amplitude,
                                                     double threshold);

/// φ′(v), without the amplitude; 0 beyond the support.
[[nodiscard]] double kernel_slope(const KernelConstants& constants, double v);

/// The kernel at q: amplitude · φ(scale · q).
[[nodiscard]] inline double kernel_value(const KernelConstants& constants, double q) {
  return constants.amplitude * kernel_profile(constants, constants.scale * q);
}

}  // namespace isl::render
