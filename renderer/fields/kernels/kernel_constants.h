// The constants of a kernel, solved once when a blob is compiled. A kernel is amplitude · φ(v), where v = scale · q and
// q is the squared distance to the skeleton over the squared radius; each kernel's file has its φ and solves its
// constants.
//
// With the radius of the surface (RadiusMeaning::surface) every kernel has the value 1 and the slope −h (in q) at q
// = 1. With POV-Ray's support radius there is the quartic alone, with scale and amplitude 1 (Murakami's (1 − r²/R²)²).
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

struct KernelConstants {
  scene::KernelShape shape = scene::KernelShape::quartic;
  bool is_convolved = false;  ///< a window to integrate (convolutions/), which has no profile
  bool is_sheet = false;      ///< the profile of a convolved plane (convolutions/sheet_*)
  double scale = 1;    ///< v = scale · q
  double support = 1;  ///< φ = 0 from here on, in v
  double amplitude = 1;
  double a = 0;    ///< gaussian: v at the surface; cauchy, its window and its sheet: ε; else 0
  double cut = 0;  ///< gaussian: e^{a − support}; else 0

  /// Where the support ends, in q.
  [[nodiscard]] double support_q() const { return support / scale; }
};

/// Precondition: hardness in (0, 500], and the shape of a convolution or a sheet quartic or cauchy (the interpreter has seen to it).
[[nodiscard]] KernelConstants kernel_constants(const scene::Kernel& kernel);

/// φ(v), without the amplitude; 0 beyond the support.
[[nodiscard]] double kernel_profile(const KernelConstants& constants, double v);

/// φ′(v), likewise.
[[nodiscard]] double kernel_slope(const KernelConstants& constants, double v);

/// The kernel at q: amplitude · φ(scale · q).
[[nodiscard]] inline double kernel_value(const KernelConstants& constants, double q) {
  return constants.amplitude * kernel_profile(constants, constants.scale * q);
}

}  // namespace isl::render
