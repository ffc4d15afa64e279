// The constants of a convolved curve's window, solved once when a blob is compiled, so that an infinite straight
// skeleton has value 1 and slope −h in q at distance r.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"

namespace isl::render {

/// The constants for segments and rings, whose integrals are taken in support radii: `scale` = 1/Q, `support` = 1,
/// `amplitude` is the factor of the integral, `a` the Cauchy window's ε in squared support radii. Precondition: the
/// shape is quartic or cauchy, with RadiusMeaning::surface.
[[nodiscard]] KernelConstants curve_constants(const scene::Kernel& kernel);

}  // namespace isl::render
