// The closed forms of convolutions, compared with graded Gauss quadrature of their definitions in long double. Every
// integral is within the rounding that it claims, which is 10⁻¹¹ of the field or less wherever a surface can be.
#include "renderer/fields/convolutions/ring_cauchy-inl.h"
#include "renderer/fields/convolutions/ring_quartic-inl.h"
#include "renderer/fields/convolutions/segment_cauchy-inl.h"
#include "renderer/fields/convolutions/segment_quartic-inl.h"
#include "renderer/fields/kernels/curve_constants.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;
using Real = long double;

/// g and −g′ from their definitions.
struct Window {
  bool is_quartic;
  Real epsilon;

  [[nodiscard]] Real value(Real y) const {
    if (is_quartic) return (1 - y) * (1 - y);
    const Real a = epsilon + y, b = epsilon + 1;
    return (1 - y) * (1 - y) * (b + 2 * a) / (a * a * b * b * b);
  }
  /// The length within which the window changes, at squared distance y.
  [[nodiscard]] Real steepest(Real y) const { return is_quartic ? 1 : std::sqrt(y + epsilon); }
  [[nodiscard]] Real fall(Real y) const {
    if (is_quartic) return 2 * (1 - y);
    const Real a = epsilon + y, b = epsilon + 1;
    return 2 * (1 - y) * (b * b + a * b + a * a) / (a * a * a * b * b * b);
  }
};

/// ∫ f over middle − half … middle + half, in panels that shrink towards 0 until they are as short as the integrand is
/// steep. On each panel it is analytic well beyond, and 30 nodes of Gauss are exact to rounding.
template <class F>
Real integral(const F& f, Real middle, Real half, Real scale) {
  std::vector<Real> cuts = {-half, half};  // measured from the middle, so that a short stretch loses no digits
  for (Real x = 0.5L * scale; x < 4; x *= 2) {
    for (const Real cut : {-x - middle, x - middle}) {
      if (std::abs(cut) < half) cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  Real sum = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    sum += boost::math::quadrature::gauss<Real, 30>::integrate([&](Real x) { return f(middle + x); }, cuts[i],
                                                               cuts[i + 1]);
  }
  return sum;
}

struct Case {
  scene::Kernel kernel;

  [[nodiscard]] KernelConstants constants() const { return curve_constants(kernel); }
  [[nodiscard]] Window window() const { return {kernel.shape == scene::KernelShape::quartic, Real(constants().a)}; }
  template <class View>
  [[nodiscard]] auto integrate(const View& view) const {
    const KernelConstants k = constants();
    if (kernel.shape == scene::KernelShape::quartic) return lanes::integrate(lanes::QuarticWindow(k), view);
    return lanes::integrate(lanes::CauchyWindow(k), view);
  }
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << scene::kKernelWords[static_cast<std::size_t>(c.kernel.shape)] << " " << c.kernel.hardness;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return fmt::format("{}_{}", scene::kKernelWords[static_cast<std::size_t>(info.param.kernel.shape)], info.index);
}

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const scene::KernelShape shape : {scene::KernelShape::quartic, scene::KernelShape::cauchy}) {
    for (const double hardness : {0.01, 1.0, 4.0, 20.0, 60.0, 500.0})
      list.push_back({{shape, scene::RadiusMeaning::surface, hardness}});
  }
  return list;
}

/// The rounding that the noise of a ray's field allows (RayLanes): 16 units in the last place.
constexpr Real kRounding = 16 * 0x1p-52L;

class Convolution : public testing::TestWithParam<Case> {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::mt19937_64 random_{7};
};

TEST_P(Convolution, SegmentIsTheIntegralOfItsWindow) {
  const Window window = GetParam().window();
  const double amplitude = GetParam().constants().amplitude;
  const double least = window.is_quartic || window.epsilon > 1e-6L ? 0 : 1e-3;
  Real worst = 0;
  for (int i = 0; i < 300; ++i) {
    // Closer to a line that is thinner than this, the quadrature itself would lose digits.
    const double rho = i % 10 == 0 ? least : std::max(least, std::pow(uniform(0, 1), i % 3 == 0 ? 6 : 1));
    const double length = std::pow(10, uniform(-9, 2));
    const double before = i % 7 == 0 ? 0 : uniform(-1, length + 1), behind = length - before;
    const auto chord = lanes::chord_of(rho * rho, before, behind, 0.5 * length);
    if (!(chord.half_length > 0)) continue;
    const Real rho2 = rho * rho;
    const Real middle = chord.middle, half = chord.half_length;
    const auto closed = GetParam().integrate(chord);
    const Real scale = window.steepest(rho2);
    const Real value = integral([&](Real v) { return window.value(rho2 + v * v); }, middle, half, scale);
    const Real across = integral([&](Real v) { return window.fall(rho2 + v * v); }, middle, half, scale);
    const Real along = integral([&](Real v) { return v * window.fall(rho2 + v * v); }, middle, half, scale);
    const std::string place = fmt::format("rho {} from {} length {}", rho, before, length);
    EXPECT_LE(std::abs(closed.value - value), kRounding * closed.value_terms) << place;
    EXPECT_LE(std::abs(closed.across - across), kRounding * closed.across_terms) << place;
    // If both sides of the foot cancel, the quadrature keeps digits that the closed form never had.
    const Real sides = integral([&](Real v) { return std::abs(v) * window.fall(rho2 + v * v); }, middle, half, scale);
    EXPECT_LE(std::abs(closed.along - along), kRounding * closed.along_terms + 1e-18L * sides) << place;
    if (amplitude * closed.value < 10) worst = std::max(worst, amplitude * std::abs(closed.value - value));
  }
  EXPECT_LE(worst, GetParam().kernel.hardness < 100 ? 1e-12L : 1e-10L);
}

TEST_P(Convolution, RingIsTheIntegralOfItsWindow) {
  const Window window = GetParam().window();
  const double amplitude = GetParam().constants().amplitude;
  Real worst = 0;
  for (int i = 0; i < 300; ++i) {
    const double radius = std::pow(10, uniform(-3, i % 2 == 0 ? 0 : 3));
    const double rho = i % 10 == 0 ? 0 : i % 3 == 0 ? std::pow(10, uniform(-9, 0)) : std::abs(radius + uniform(-1, 1));
    const double z = i % 4 == 0 ? 0 : uniform(-1, 1);
    const lanes::RingView<double> view{radius, rho, (rho - radius) * (rho - radius) + z * z};
    if (!(view.distance2 < 1)) continue;
    const auto closed = GetParam().integrate(view);
    const Real y0 = view.distance2, r = radius, a = 2 * r * Real(rho);
    // The argument is the arc's length from the nearest point.
    const auto y = [&](Real s) {
      const Real sine = std::sin(s / (2 * r));
      return y0 + 2 * a * sine * sine;
    };
    const Real sigma = (1 - y0) / (2 * a);
    const Real end = r * (sigma >= 1 ? std::acos(Real(-1)) : 2 * std::asin(std::sqrt(sigma)));
    const Real scale = std::min(window.steepest(y0), r);
    const Real value = integral([&](Real s) { return window.value(y(s)); }, 0, end, scale);
    const Real whole = integral([&](Real s) { return window.fall(y(s)); }, 0, end, scale);
    const std::string place = fmt::format("radius {} rho {} z {}", radius, rho, z);
    EXPECT_LE(std::abs(closed.value - value), kRounding * closed.value_terms) << place;
    EXPECT_LE(std::abs(closed.whole - whole), kRounding * closed.whole_terms) << place;
    if (rho > 0) {
      const Real radial =
          r / rho * integral([&](Real s) { return std::cos(s / r) * window.fall(y(s)); }, 0, end, scale);
      // Near the axis the quadrature loses digits that the closed form keeps.
      const Real slack = 1e-17L * r / rho * closed.whole;
      EXPECT_LE(std::abs(closed.radial - radial), kRounding * closed.radial_terms + slack) << place;
    }
    if (amplitude * closed.value < 10) worst = std::max(worst, amplitude * std::abs(closed.value - value) / (1 + r));
  }
  EXPECT_LE(worst, GetParam().kernel.hardness < 100 ? 1e-12L : 1e-10L);
}

/// Next to the border, where the surfaces of hard windows are, those lose no digits however small the field is: Gauss's
/// rule leaves 10⁻¹³ of it (cauchy_border-inl.h), and its 16 terms are rounded.
constexpr double kAtBorder = 1e-13 + 16 * 0x1p-52;

TEST_P(Convolution, LosesNoDigitsNextToTheBorderIfHard) {
  const Window window = GetParam().window();
  if (!window.is_quartic && !lanes::CauchyWindow(GetParam().constants()).is_steep) {
    EXPECT_LE(GetParam().kernel.hardness, 20);
    return;
  }
  for (int i = 0; i < 300; ++i) {
    const double depth = std::pow(2, uniform(-20, -5));
    const double rho2 = 1 - depth, reach = std::sqrt(depth), length = std::pow(10, uniform(-2, 1)) * reach;
    const double before = uniform(-0.5 * reach, length + 0.5 * reach);
    const auto chord = lanes::chord_of(rho2, before, length - before, 0.5 * length);
    if (!(chord.half_length > 1e-3 * reach)) continue;
    const Real line = integral([&](Real v) { return window.value(rho2 + v * v); }, chord.middle, chord.half_length, 1);
    EXPECT_NEAR(static_cast<double>(GetParam().integrate(chord).value / line), 1, kAtBorder)
        << rho2 << " " << before << " " << length;

    // From rings that the border cuts in a point to those that are almost as deep all around.
    const double radius = std::pow(10, uniform(-6, 2)), z = std::sqrt(rho2);
    const lanes::RingView<double> view{radius, radius, z * z};
    const Real s = 1 - Real(z * z), two_a = 4 * Real(radius) * radius, sigma = s / two_a;
    const Real angle = sigma >= 1 ? std::acos(Real(-1)) : 2 * std::asin(std::sqrt(sigma));
    const auto at = [&](Real phi) { return window.value(1 - s + two_a * std::sin(phi / 2) * std::sin(phi / 2)); };
    const Real ring = radius * integral(at, 0, angle, 1);
    EXPECT_NEAR(static_cast<double>(GetParam().integrate(view).value / ring), 1, kAtBorder) << radius << " " << depth;
  }
}

TEST_P(Convolution, HalvesOfASegmentAddUpToTheWhole) {
  for (int i = 0; i < 200; ++i) {
    const double rho = uniform(0.05, 1), length = uniform(0.1, 3), before = uniform(-1, length + 1);
    const double part = uniform(0, length);
    const auto of = [&](double from, double l) { return lanes::chord_of(rho * rho, from, l - from, 0.5 * l); };
    const auto value = [&](const lanes::Chord<double>& chord) {
      return chord.half_length > 0 ? GetParam().integrate(chord).value : 0.0;
    };
    const auto whole = of(before, length);
    if (!(whole.half_length > 0)) continue;
    const auto f = GetParam().integrate(whole);
    EXPECT_NEAR(value(of(before, part)) + value(of(before - part, length - part)), f.value,
                static_cast<double>(2 * kRounding) * f.value_terms);
  }
}

TEST_P(Convolution, ShortSegmentIsItsLengthTimesTheWindow) {
  const Window window = GetParam().window();
  for (const double length : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const double rho : {0.3, 0.7}) {
      const auto f = GetParam().integrate(lanes::chord_of(rho * rho, 0.5 * length, 0.5 * length, 0.5 * length));
      const auto expected = static_cast<double>(length * window.value(Real(rho) * rho));
      EXPECT_NEAR(f.value, expected, (1e-11 + length * length * 20) * f.value_terms);
    }
  }
}

TEST_P(Convolution, LargeRingIsALine) {
  for (const double rho : {0.2, 0.6, 0.9}) {
    const auto line = GetParam().integrate(lanes::chord_of(rho * rho, 1e9, 1e9, 1e9));
    const auto ring = GetParam().integrate(lanes::RingView<double>{1e9, 1e9, rho * rho});
    EXPECT_NEAR(ring.value, line.value, 1e-8 * line.value_terms);
    EXPECT_NEAR(ring.whole, line.across, 1e-8 * line.across_terms);
  }
}

TEST_P(Convolution, InfiniteLineHasItsSurfaceAtTheRadiusWithTheHardnessAsSlope) {
  const KernelConstants k = GetParam().constants();
  const lanes::Chord<double> chord = lanes::chord_of(k.scale, 1e9, 1e9, 1e9);
  const auto f = GetParam().integrate(chord);
  const double rounding = 1e-14 * std::max(1.0, GetParam().kernel.hardness);
  EXPECT_NEAR(k.amplitude * f.value, 1, rounding);
  EXPECT_NEAR(k.amplitude * k.scale * f.across, GetParam().kernel.hardness, rounding * GetParam().kernel.hardness);
}

INSTANTIATE_TEST_SUITE_P(Windows, Convolution, testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace isl::render
