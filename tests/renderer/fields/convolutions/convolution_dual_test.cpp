// The gradients of convolutions, compared with the derivatives of their values: the closed forms are templates, so they
// accept numbers that carry their derivatives. The same is done for the slope of sheets.
#include "renderer/fields/convolutions/ring_cauchy-inl.h"
#include "renderer/fields/convolutions/ring_quartic-inl.h"
#include "renderer/fields/convolutions/segment_cauchy-inl.h"
#include "renderer/fields/convolutions/segment_quartic-inl.h"
#include "renderer/fields/kernels/cubic-inl.h"
#include "renderer/fields/kernels/sheet_cauchy-inl.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;
using scene::Vec3;

/// A number and its gradient.
struct Dual {
  Dual() = default;
  explicit Dual(double of, const Vec3& slope = Vec3(0)) : value(of), gradient(slope) {}

  double value = 0;
  Vec3 gradient{0};
};

Dual operator+(const Dual& a, const Dual& b) { return Dual(a.value + b.value, a.gradient + b.gradient); }
Dual operator-(const Dual& a, const Dual& b) { return Dual(a.value - b.value, a.gradient - b.gradient); }
Dual operator*(const Dual& a, const Dual& b) {
  return Dual(a.value * b.value, a.gradient * b.value + b.gradient * a.value);
}
Dual operator/(const Dual& a, const Dual& b) {
  return Dual(a.value / b.value, (a.gradient - b.gradient * (a.value / b.value)) / b.value);
}
bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
Dual min(const Dual& a, const Dual& b) { return b < a ? b : a; }
Dual max(const Dual& a, const Dual& b) { return a < b ? b : a; }
Dual abs(const Dual& a) { return a.value < 0 ? Dual(0) - a : a; }
Dual select(bool condition, const Dual& yes, const Dual& no) { return condition ? yes : no; }
Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return Dual(root, root > 0 ? a.gradient / (2 * root) : Vec3(0));  // a value that is cut off at 0 stays there
}

/// A point in dual numbers.
struct Place {
  explicit Place(const Vec3& p) : x(p.x, {1, 0, 0}), y(p.y, {0, 1, 0}), z(p.z, {0, 0, 1}) {}

  Dual x, y, z;
};

void expect_same(const Vec3& gradient, const Vec3& expected, double terms, const Vec3& p) {
  EXPECT_LE((gradient - expected).length(), 1e-12 * terms) << gradient << " is not " << expected << " at " << p;
}

/// Calls check(window) with both windows of a few hardnesses.
template <class Check>
void with_windows(const Check& check) {
  for (const double hardness : {0.5, 4.0, 20.0}) {
    check(lanes::QuarticWindow(kernel_constants(reference::convolved(reference::quartic(hardness)))));
    check(lanes::CauchyWindow(kernel_constants(reference::convolved(reference::cauchy(hardness)))));
  }
}

TEST(ConvolutionDual, GradientOfASegmentIsThatOfItsValue) {
  reference::RandomSource random(301);
  with_windows([&](const auto& window) {
    for (int i = 0; i < 200; ++i) {
      // The segment lies on the x axis, from the origin on.
      const double length = random.between(0.05, 2);
      const Vec3 p = Vec3(random.between(-0.8, length + 0.8), random.between(-0.8, 0.8), random.between(-0.8, 0.8));
      const double rho2 = p.y * p.y + p.z * p.z;
      const auto chord = lanes::chord_of(rho2, p.x, length - p.x, 0.5 * length);
      if (!(rho2 < 1 && chord.half_length > 1e-3)) continue;
      const auto f = lanes::integrate(window, chord);
      const Vec3 gradient = Vec3(-f.along, p.y * f.across, p.z * f.across) * -2.0;

      const Place at(p);
      const Dual value = lanes::integrate(window, lanes::chord_of(at.y * at.y + at.z * at.z, at.x, Dual(length) - at.x,
                                                                  Dual(0.5 * length)))
                             .value;
      EXPECT_NEAR(value.value, f.value, 1e-14 * f.value_terms);
      expect_same(gradient, value.gradient, f.across_terms + f.along_terms, p);
    }
  });
}

TEST(ConvolutionDual, GradientOfARingIsThatOfItsValue) {
  reference::RandomSource random(302);
  with_windows([&](const auto& window) {
    for (int i = 0; i < 200; ++i) {
      // The circle lies about the z axis.
      const double radius = random.between(0.1, 2);
      const Vec3 p = random.in_ball(radius + 0.8);
      const double rho = std::hypot(p.x, p.y), d2 = (rho - radius) * (rho - radius) + p.z * p.z;
      if (!(d2 < 0.98)) continue;
      const auto f = lanes::integrate(window, lanes::RingView<double>{radius, rho, d2});
      const Vec3 gradient = (p * f.whole - Vec3(p.x, p.y, 0) * f.radial) * -2.0;

      const Place at(p);
      const Dual from_axis = sqrt(at.x * at.x + at.y * at.y), beside = from_axis - Dual(radius);
      const lanes::RingView<Dual> view{Dual(radius), from_axis, beside * beside + at.z * at.z};
      const Dual value = lanes::integrate(window, view).value;
      EXPECT_NEAR(value.value, f.value, 1e-14 * f.value_terms);
      expect_same(gradient, value.gradient, f.whole_terms + f.radial_terms, p);
    }
  });
}

template <class Sheet>
void expect_slopes(const KernelConstants& constants) {
  const Sheet sheet(constants);
  for (int i = 1; i < 100; ++i) {
    const double v = constants.support * i / 100;
    alignas(64) double slope[lanes::kOctet], bend[lanes::kOctet];
    lanes::store(sheet.value_and_slope(lanes::Octet(v)).slope, slope);
    lanes::store(sheet.curvature(lanes::Octet(v)), bend);
    const double expected = sheet.value(Dual(v, {1, 0, 0})).gradient.x;
    EXPECT_NEAR(slope[0], expected, 1e-13 * std::abs(expected)) << v;
    // The curvature is compared with the difference of slopes.
    const double step = constants.support * 1e-6;
    const double rise =
        sheet.value(Dual(v + step, {1, 0, 0})).gradient.x - sheet.value(Dual(v - step, {1, 0, 0})).gradient.x;
    EXPECT_NEAR(bend[0], rise / (2 * step), 1e-6 * bend[0]) << v;
  }
}

TEST(ConvolutionDual, SlopesOfSheetsAreThoseOfTheirValues) {
  for (const double hardness : {0.5, 4.0, 20.0}) {
    expect_slopes<lanes::Cubic>(kernel_constants(reference::over_sheets(reference::quartic(hardness))));
    expect_slopes<lanes::CauchySheet>(kernel_constants(reference::over_sheets(reference::cauchy(hardness))));
  }
}

}  // namespace
}  // namespace isl::render
