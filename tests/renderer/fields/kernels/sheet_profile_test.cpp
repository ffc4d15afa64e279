// The profiles of convolved planes, compared with their windows integrated numerically over a plane.
#include "renderer/fields/kernels/kernel_constants.h"

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

scene::Kernel sheet(scene::KernelShape shape, double hardness) {
  return {shape, scene::RadiusMeaning::surface, hardness, scene::FieldMode::sheet};
}

const scene::Kernel kSheets[] = {sheet(scene::KernelShape::quartic, 0.3), sheet(scene::KernelShape::quartic, 4),
                                 sheet(scene::KernelShape::quartic, 500), sheet(scene::KernelShape::cauchy, 0.3),
                                 sheet(scene::KernelShape::cauchy, 1),    sheet(scene::KernelShape::cauchy, 4),
                                 sheet(scene::KernelShape::cauchy, 20),   sheet(scene::KernelShape::cauchy, 90),
                                 sheet(scene::KernelShape::cauchy, 500)};

/// The window at the squared distance v: the kernel of the definition, zero and flat at the border Q.
long double window(const KernelConstants& constants, long double v) {
  const long double border = constants.support;
  if (constants.shape == scene::KernelShape::quartic) return (1 - v / border) * (1 - v / border);
  const auto k = [&](long double at) { return 1 / ((constants.a + at) * (constants.a + at)); };
  const long double slope = -2 * k(border) / (constants.a + border);
  return k(v) - k(border) - slope * (v - border);
}

/// The window's integral over a plane at the squared distance v, in rings of the radius ρ about the foot of the point.
long double over_the_plane(const KernelConstants& constants, long double v) {
  const long double end = std::sqrt(constants.support - v);
  const auto ring = [&](long double rho) {
    return 2 * 3.14159265358979323846L * rho * window(constants, v + rho * rho);
  };
  long double sum = 0, from = 0;
  // The steps grow from the width of the hardest spike.
  for (long double to = end * 0x1p-40L; from < end; to *= 2) {
    to = std::min(to, end);
    sum += boost::math::quadrature::gauss<long double, 30>::integrate(ring, from, to);
    from = to;
  }
  return sum;
}

TEST(SheetProfile, IsTheWindowIntegratedOverThePlane) {
  for (const scene::Kernel& kernel : kSheets) {
    const KernelConstants constants = kernel_constants(kernel);
    const long double one = over_the_plane(constants, constants.support / 4);
    const double profile_one = kernel_profile(constants, constants.support / 4);
    for (const double fraction : {0.002, 0.03, 0.1, 0.4, 0.7, 0.9, 0.95}) {
      const double v = constants.support * fraction;
      const double expected = static_cast<double>(over_the_plane(constants, v) / one);
      EXPECT_NEAR(kernel_profile(constants, v) / profile_one, expected, 1e-12 * expected)
          << kernel.hardness << ' ' << fraction;
    }
  }
}

TEST(SheetProfile, HasTheValueOneAndTheSlopeOfItsHardnessAtTheRadius) {
  for (const scene::Kernel& kernel : kSheets) {
    const KernelConstants constants = kernel_constants(kernel);
    const double h = kernel.hardness, step = 1e-5 / h;
    EXPECT_NEAR(kernel_value(constants, 1), 1, 1e-13) << h;
    const double slope = (kernel_value(constants, 1 + step) - kernel_value(constants, 1 - step)) / (2 * step);
    EXPECT_NEAR(slope / h, -1, 1e-6) << h;
  }
}

TEST(SheetProfile, OfCauchysIsTheUnwindowedGaussiansOnThePlane) {
  for (const double h : {0.01, 0.3, 1.0, 4.0, 20.0, 90.0}) {
    const KernelConstants constants = kernel_constants(sheet(scene::KernelShape::cauchy, h));
    EXPECT_NEAR(std::log(kernel_value(constants, 0)) / h, 1, 1e-11) << h;
  }
}

}  // namespace
}  // namespace isl::render
