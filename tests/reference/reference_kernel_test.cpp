// The reference kernels against their definitions: normalisation, slope, border, and enclosures that hold what they
// must.
#include "tests/reference/reference_kernel.h"

#include "tests/reference/near.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

namespace isl::reference {
namespace {

class SurfaceKernel : public testing::TestWithParam<scene::Kernel> {};

TEST_P(SurfaceKernel, IsOneWithSlopeMinusHardnessAtTheRadius) {
  const ReferenceKernel kernel(GetParam());
  EXPECT_CLOSE(kernel.value(1.0L), 1, 1e-16L);
  EXPECT_CLOSE(kernel.slope(1.0L) / GetParam().hardness, -1, 1e-16L);
}

TEST_P(SurfaceKernel, SlopeIsTheDerivativeOfTheValue) {
  const ReferenceKernel kernel(GetParam());
  const long double border = kernel.support().middle();
  for (int i = 1; i < 50; ++i) {
    const long double q = border * i / 50, step = border * 1e-6L;
    const long double difference = (kernel.value(q + step) - kernel.value(q - step)) / (2 * step);
    EXPECT_CLOSE(kernel.slope(q) / difference, 1, 1e-6L) << "q = " << q;
  }
}

TEST_P(SurfaceKernel, EndsAtTheSupportWithZeroValueAndSlope) {
  const ReferenceKernel kernel(GetParam());
  const long double border = kernel.support().hi;
  EXPECT_EQ(kernel.value(border), 0);
  EXPECT_EQ(kernel.slope(border), 0);
  EXPECT_GT(kernel.value(border * (1 - 1e-6L)), 0);
  EXPECT_LT(kernel.value(border * (1 - 1e-6L)), 1e-6L);
}

TEST_P(SurfaceKernel, EnclosuresAreTightAndHoldTheirEnds) {
  const ReferenceKernel kernel(GetParam());
  const Interval value = kernel.value(Interval(0.5L, 0.9L));
  EXPECT_TRUE(value.contains(kernel.value(0.7L)));
  // The exponential multiplies the error of its argument by the argument, up to 500.
  EXPECT_CLOSE(value.hi / kernel.value(0.5L), 1, 1e-15L);
  EXPECT_CLOSE(value.lo / kernel.value(0.9L), 1, 1e-15L);
}

INSTANTIATE_TEST_SUITE_P(Hardness, SurfaceKernel,
                         testing::Values(quartic(0.5), quartic(4), quartic(500), gaussian(0.5), gaussian(4),
                                         gaussian(60), gaussian(500)));

TEST(ReferenceKernel, GaussianIsBlinnsExponentialLessATangent) {
  // At h = 4: b·(e^{-aq} − tangent at Q) with the constants to which the definition reduces, written out in full.
  const long double delta = 1e-3L, a = 4 * (1 - delta * (1 + std::log(1 / delta))) / (1 - delta);
  const long double border = 1 + std::log(1 / delta) / a;
  const auto raw = [&](long double q) { return std::exp(-a * q) - std::exp(-a * border) * (1 - a * (q - border)); };
  const ReferenceKernel kernel(gaussian(4));
  EXPECT_CLOSE(kernel.support().middle(), border, 1e-17L);
  for (const long double q : {0.0L, 0.3L, 1.0L, 1.7L, 2.6L})
    EXPECT_CLOSE(kernel.value(q), raw(q) / raw(1), 1e-15L * kernel.value(0.0L));
}

TEST(ReferenceKernel, SupportMeaningIsPovRaysParabola) {
  const ReferenceKernel kernel(kPovRay);
  EXPECT_EQ(kernel.value(0.0L), 1);
  EXPECT_CLOSE(kernel.value(0.25L), 0.5625L, 1e-17L);
  EXPECT_CLOSE(kernel.slope(0.25L), -1.5L, 1e-17L);
  EXPECT_EQ(kernel.value(1.0L), 0);
}

}  // namespace
}  // namespace isl::reference
