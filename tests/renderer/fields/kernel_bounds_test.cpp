// The kernels' bounds of f″ and f⁗ along a ray, against dense samples of the derivatives written out by hand.
#include "renderer/fields/kernels/gaussian-inl.h"
#include "renderer/fields/kernels/quartic-inl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;

double first_lane(const lanes::Octet& x) {
  alignas(64) double out[lanes::kOctet];
  lanes::store(x, out);
  return out[0];
}

struct Sample {
  double second, fourth;
};

Sample quartic_at(double v0, double kappa, double u) {
  return {-4 * kappa * (1 - v0 - 3 * u), 24 * kappa * kappa};
}

Sample gaussian_at(const KernelConstants& k, double v0, double kappa, double u) {
  const double e = std::exp(k.a - v0 - u);
  return {kappa * e * (4 * u - 2) + 2 * kappa * k.cut, kappa * kappa * e * (16 * u * u - 48 * u + 12)};
}

/// Calls check(v0, u_near, u_far) over a lattice of intervals within the support.
template <class Check>
void over_lattice(double support, const Check& check) {
  for (int i = 0; i < 12; ++i) {
    const double v0 = support * i / 12;
    for (int j = 0; j < 24; ++j) {
      for (int k = j + 1; k <= 24; ++k) check(v0, (support - v0) * j / 24, (support - v0) * k / 24);
    }
  }
}

template <class Kernel, class At>
void expect_bounds_hold(const Kernel& kernel, double support, const At& at) {
  constexpr double kKappa = 0.7;
  over_lattice(support, [&](double v0, double u_near, double u_far) {
    const lanes::SecondAndFourth bounds = kernel.on_quadratic(lanes::Octet(v0), lanes::Octet(kKappa), lanes::Octet(u_near),
                                                              lanes::Octet(u_far));
    const double low = first_lane(bounds.low), high = first_lane(bounds.high), fourth = first_lane(bounds.fourth);
    for (int i = 0; i <= 16; ++i) {
      const Sample sample = at(v0, kKappa, u_near + (u_far - u_near) * i / 16);
      const double slack = 1e-13 * std::max({std::abs(low), std::abs(high), fourth});  // rounding of the sample itself
      ASSERT_GE(sample.second, low - slack) << v0 << ' ' << u_near << ' ' << u_far;
      ASSERT_LE(sample.second, high + slack) << v0 << ' ' << u_near << ' ' << u_far;
      ASSERT_LE(std::abs(sample.fourth), fourth + slack) << v0 << ' ' << u_near << ' ' << u_far;
    }
  });
}

TEST(KernelBounds, QuarticHoldsOverDenseSamples) {
  const KernelConstants k = kernel_constants({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4});
  expect_bounds_hold(lanes::Quartic(k), k.support, quartic_at);
}

TEST(KernelBounds, GaussianHoldsOverDenseSamplesAtEveryHardness) {
  for (const double hardness : {0.01, 0.5, 4.0, 60.0, 500.0}) {
    const KernelConstants k = kernel_constants({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, hardness});
    expect_bounds_hold(lanes::Gaussian(k), k.support,
                       [&](double v0, double kappa, double u) { return gaussian_at(k, v0, kappa, u); });
  }
}

TEST(KernelBounds, GaussianTailIsBoundedByItsOwnSize) {
  // A ray through the middle of a hard component is worth e^300 there and next to nothing in the tail: the bound in the tail
  // must be of the tail's size, or intervals there would be halved to no end.
  const KernelConstants k = kernel_constants({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 300});
  const lanes::Gaussian kernel(k);
  const double u = k.support - 1;
  const double fourth = first_lane(kernel.on_quadratic(lanes::Octet(0.0), lanes::Octet(1.0), lanes::Octet(u), lanes::Octet(u + 0.5)).fourth);
  EXPECT_LT(fourth, 1.01 * 16 * u * u * std::exp(k.a - u));
}

}  // namespace
}  // namespace isl::render
