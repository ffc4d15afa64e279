// The reference kernels, compared with their definitions: normalisation, slope, border, shape, and correct enclosures.
#include "renderer/reference/reference_kernel.h"

#include "tests/reference/near.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace isl::reference {
namespace {

class SurfaceKernel : public testing::TestWithParam<scene::Kernel> {};

/// q at equal steps from the middle to the border of the support.
std::vector<long double> samples(const ReferenceKernel& kernel, int count) {
  std::vector<long double> list;
  for (int i = 0; i <= count; ++i) list.push_back(kernel.support().middle() * i / count);
  return list;
}

TEST_P(SurfaceKernel, IsOneWithSlopeMinusHardnessAtTheRadius) {
  const ReferenceKernel kernel(GetParam());
  EXPECT_CLOSE(kernel.value(1.0L), 1, 1e-16L);
  EXPECT_CLOSE(kernel.slope(1.0L) / GetParam().hardness, -1, 1e-16L);
  EXPECT_TRUE(kernel.over(1).value.contains(1));
  EXPECT_TRUE(kernel.over(1).slope.contains(-GetParam().hardness));
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

TEST_P(SurfaceKernel, BendIsTheDerivativeOfTheSlope) {
  const ReferenceKernel kernel(GetParam());
  const long double border = kernel.support().middle();
  for (int i = 1; i < 50; ++i) {
    const long double q = border * (i + 0.3L) / 50, step = border * 1e-6L;
    const long double difference = (kernel.slope(q + step) - kernel.slope(q - step)) / (2 * step);
    EXPECT_CLOSE(kernel.over(q).bend.middle(), difference, 1e-6L * std::abs(difference)) << "q = " << q;
  }
}

TEST_P(SurfaceKernel, EndsAtTheSupportWithZeroValueAndSlope) {
  const ReferenceKernel kernel(GetParam());
  const long double border = kernel.support().hi();
  for (const long double q : {border, 2 * border}) {
    EXPECT_EQ(kernel.value(q), 0);
    EXPECT_EQ(kernel.slope(q), 0);
  }
  EXPECT_GT(kernel.value(border * (1 - 1e-6L)), 0);
  EXPECT_LT(kernel.value(border * (1 - 1e-6L)), 1e-6L);
  EXPECT_LT(kernel.slope(border * (1 - 1e-6L)), 0);
  EXPECT_GT(kernel.slope(border * (1 - 1e-6L)) / GetParam().hardness, -1e-3L);
}

TEST_P(SurfaceKernel, FallsAndIsConvex) {
  const ReferenceKernel kernel(GetParam());
  const std::vector<long double> q = samples(kernel, 2000);
  for (std::size_t i = 1; i + 1 < q.size(); ++i) {
    const Jet left = kernel.over(q[i - 1]), here = kernel.over(q[i]);
    ASSERT_GT(left.value.lo(), here.value.hi()) << "q = " << q[i];
    // φ is convex: the slope of every chord lies between the slopes at its ends, and those rise.
    const Interval chord = (here.value - left.value) / (Interval(q[i]) - Interval(q[i - 1]));
    ASSERT_LE(left.slope.lo(), chord.hi()) << "q = " << q[i];
    ASSERT_GE(here.slope.hi(), chord.lo()) << "q = " << q[i];
    ASSERT_LE(left.slope.lo(), here.slope.hi()) << "q = " << q[i];
    ASSERT_LT(here.slope.hi(), 0) << "q = " << q[i];
  }
}

TEST_P(SurfaceKernel, EnclosuresAreTightAndHoldTheirEnds) {
  const ReferenceKernel kernel(GetParam());
  const Interval value = kernel.over({0.5L, 0.9L}).value;
  EXPECT_TRUE(value.contains(kernel.value(0.7L)));
  // The exponential multiplies the error of its argument by the argument, up to 500. The softer a cauchy is, the less
  // its two conditions differ, from which its constants follow.
  const long double tolerance = 1e-15L * std::max(1.0, 5 / GetParam().hardness);
  EXPECT_CLOSE(value.hi() / kernel.value(0.5L), 1, tolerance);
  // An interval is kept by its middle and radius: its lower end has the digits of the upper one.
  EXPECT_CLOSE(value.lo(), kernel.value(0.9L), tolerance * kernel.value(0.5L));
  EXPECT_CLOSE(kernel.least({0.5L, 0.9L}) / kernel.value(0.9L), 1, tolerance);
}

TEST_P(SurfaceKernel, EnclosuresHoldDenseSamples) {
  const ReferenceKernel kernel(GetParam());
  // The intervals extend beyond the support, too.
  const long double far = kernel.support().hi() * 1.2L;
  for (int from = 0; from < 12; ++from) {
    for (int to = from + 1; to <= 12; ++to) {
      const long double low = far * from / 12, high = far * to / 12;
      const Interval stretch(low, high);
      const Jet over = kernel.over(stretch);
      for (int i = 0; i <= 40; ++i) {
        const long double q = std::min(low + (high - low) * i / 40, high);
        ASSERT_TRUE(over.value.contains(kernel.value(q))) << "q = " << q << " of " << low << " to " << high;
        ASSERT_TRUE(over.slope.contains(kernel.slope(q))) << "q = " << q << " of " << low << " to " << high;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Hardness, SurfaceKernel,
                         testing::Values(quartic(0.5), quartic(4), quartic(500), cubic(0.5), cubic(4), cubic(500),
                                         gaussian(0.5), gaussian(4), gaussian(60), gaussian(500), soft(0.1), soft(0.4),
                                         soft(4), soft(60), soft(500), metaball(0.2), metaball(0.5), metaball(1),
                                         metaball(4), metaball(60), metaball(500), cauchy(0.1), cauchy(1), cauchy(4),
                                         cauchy(60), cauchy(500)));

TEST(ReferenceKernel, GaussianIsBlinnsExponentialLessATangent) {
  // At h = 4: b·(e^{-aq} − tangent at Q), with the constants from the definition written out in full.
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

/// φ is w(q/Q)/w(1/Q) for the w of a kernel's paper, and its Q is where −x·w′/w = h at x = 1/Q. Tolerances: w is
/// correct to 1e-18, of which a hard kernel's w(1/Q) is only a small part; the difference quotient is correct to eight
/// digits.
void expect_is_scaled(const scene::Kernel& named, const std::function<long double(long double)>& w) {
  SCOPED_TRACE(named.hardness);
  const ReferenceKernel kernel(named);
  const long double border = kernel.support().middle(), x = 1 / border, step = 1e-5L * (1 - x);
  EXPECT_CLOSE(-x * (w(x + step) - w(x - step)) / (2 * step) / w(x) / named.hardness, 1, 1e-8L);
  for (const long double q : samples(kernel, 100)) {
    const long double expected = w(q / border) / w(x);
    EXPECT_CLOSE(kernel.value(q), expected, 1e-18L / w(x) * (1 + expected)) << "q = " << q;
  }
}

TEST(ReferenceKernel, CubicIsAThirdPower) {
  for (const double hardness : {0.1, 1.0, 4.0, 60.0, 500.0}) {
    expect_is_scaled(cubic(hardness), [](long double x) { return (1 - x) * (1 - x) * (1 - x); });
  }
}

TEST(ReferenceKernel, SoftIsWyvillsPolynomial) {
  for (const double hardness : {0.1, 0.4, 1.0, 4.0, 60.0, 500.0}) {
    expect_is_scaled(soft(hardness), [](long double x) { return 1 - 22 * x / 9 + 17 * x * x / 9 - 4 * x * x * x / 9; });
  }
}

TEST(ReferenceKernel, MetaballIsNishimurasCoreAndShell) {
  for (const double hardness : {0.2, 0.45, 0.55, 1.0, 4.0, 60.0, 500.0}) {
    expect_is_scaled(metaball(hardness), [](long double x) {
      const long double rho = std::sqrt(x);
      return rho <= 1 / 3.0L ? 1 - 3 * x : 1.5L * (1 - rho) * (1 - rho);
    });
  }
}

TEST(ReferenceKernel, MetaballIsContinuousWithItsSlopeWhereItsPiecesMeet) {
  for (const double hardness : {0.2, 0.5, 1.0, 4.0, 500.0}) {
    const ReferenceKernel kernel(metaball(hardness));
    const long double meeting = kernel.support().middle() / 9, step = meeting * 1e-15L;
    const auto [value, slope, bend] = kernel.over({meeting - step, meeting + step});
    EXPECT_LT(value.width(), 1e-14L * value.hi());
    EXPECT_LT(slope.width(), 1e-14L * slope.magnitude());
    // φ″ jumps from zero to ¾|φ′|/q there: the slope is constant before, and a thousandth later 0.00075 of it is gone.
    const auto change = [&](long double a, long double b) {
      return kernel.slope(meeting * b) - kernel.slope(meeting * a);
    };
    EXPECT_CLOSE(change(0.999L, 1), 0, 1e-15L * slope.magnitude());
    EXPECT_GT(change(1, 1.001L), 5e-4L * slope.magnitude());
    EXPECT_LE(bend.lo(), 0);
    EXPECT_GE(bend.hi(), change(1, 1.001L) / (meeting * 0.001L));
  }
}

/// Cauchy's kernel minus its tangent at Q, and its derivative, in terms of σ² and Q as in the definition.
struct WindowedCauchy {
  long double sigma_squared, border;

  [[nodiscard]] long double k(long double q) const { return std::pow(1 + sigma_squared * q, -2.0L); }
  [[nodiscard]] long double dk(long double q) const {
    return -2 * sigma_squared * std::pow(1 + sigma_squared * q, -3.0L);
  }
  [[nodiscard]] long double raw(long double q) const { return k(q) - k(border) - dk(border) * (q - border); }
  [[nodiscard]] long double hardness() const { return -(dk(1) - dk(border)) / raw(1); }
};

TEST(ReferenceKernel, CauchyIsTheKernelLessItsTangentWithTheKnownConstants) {
  struct Known {
    double hardness;
    long double root_of_border, sigma;
  };
  for (const Known& known : {Known{1, 2.0755L, 0.6025L}, Known{2, 1.5917L, 0.9520L}, Known{4, 1.2970L, 1.7189L},
                             Known{8, 1.1399L, 4.2841L}}) {
    SCOPED_TRACE(known.hardness);
    const ReferenceKernel kernel(cauchy(known.hardness));
    const long double border = kernel.support().middle();
    EXPECT_CLOSE(std::sqrt(border), known.root_of_border, 5e-5L);
    // Only one σ belongs to this Q: the larger σ is, the steeper the kernel at the radius.
    long double low = known.sigma * 0.9L, high = known.sigma * 1.1L;
    for (int i = 0; i < 70; ++i) {
      const long double middle = (low + high) / 2;
      (WindowedCauchy{middle * middle, border}.hardness() < known.hardness ? low : high) = middle;
    }
    EXPECT_CLOSE(low, known.sigma, 5e-5L);
    const WindowedCauchy defined{low * low, border};
    for (const long double q : samples(kernel, 100))
      EXPECT_CLOSE(kernel.value(q), defined.raw(q) / defined.raw(1), 1e-15L * kernel.value(0.0L)) << "q = " << q;
  }
}

TEST(ReferenceKernel, CauchyHasTheExponentialOfItsHardnessInTheMiddle) {
  for (const double hardness : {0.1, 1.0, 4.0, 60.0, 500.0}) {
    const long double expected = std::exp(static_cast<long double>(hardness));
    const Interval middle = ReferenceKernel(cauchy(hardness)).over(0).value;
    EXPECT_CLOSE(middle.middle() / expected, 1, 1e-15L) << hardness;
    EXPECT_LT(middle.width(), 1e-14L * std::max(1.0, 1 / hardness) * expected) << hardness;
  }
}

}  // namespace
}  // namespace isl::reference
