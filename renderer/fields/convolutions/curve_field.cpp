#include "renderer/fields/convolutions/curve_field.h"

#include "renderer/fields/convolutions/windows-inl.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

namespace one = HWY_NAMESPACE;
using Chord = one::Chord<double>;
using RingView = one::RingView<double>;

constexpr double kPi = 3.14159265358979323846;
/// Rounding is below 16 units in the last place of the terms
/// (tests/renderer/fields/convolutions/convolution_integrals_test.cpp).
constexpr double kRounding = 0x1p-48;

/// The integrals over a chord (Chord) or a ring (RingView).
template <class View>
auto integral(const KernelConstants& kernel, const View& view) {
  return one::with_window(kernel, [&](const auto& window) { return one::integrate(window, view); });
}
double window_at(const KernelConstants& kernel, double y) {
  return one::with_window(kernel, [&](const auto& window) { return window.value(y); });
}

/// An upper (side +1) or lower (−1) bound of an integral.
template <class View>
double bound(const KernelConstants& kernel, const View& view, double side) {
  const auto f = integral(kernel, view);
  return std::max(0.0, f.value + side * kRounding * f.value_terms);
}

Chord chord_in(double rho, double before, double behind) {
  return one::chord_of(rho * rho, before, behind, 0.5 * (before + behind));
}

double rim_distance2(const RingView& ring, double z) {
  const double across = ring.rho - ring.ring_radius;
  return across * across + z * z;
}

}  // namespace

CurveSample curve_sample(const KernelConstants& kernel, const Segment& segment, const Vec3& p) {
  const double unit = per_support(kernel, segment);
  const Vec3 from_a = p - segment.a, from_b = from_a - segment.axis * segment.length;
  const double x_a = from_a.dot(segment.axis), x_b = from_b.dot(segment.axis);
  // ρ is computed from the nearer end: the distance of the farther one would cost digits.
  const Vec3 across = std::abs(x_a) < std::abs(x_b) ? from_a - segment.axis * x_a : from_b - segment.axis * x_b;
  const double rho2 = across.length2() * unit * unit;
  const Chord chord = one::chord_of(rho2, x_a * unit, -x_b * unit, 0.5 * segment.length * unit);
  if (!(rho2 < 1 && chord.half_length > 0)) return {};
  const auto f = integral(kernel, chord);
  return {f.value, (across * (unit * f.across) - segment.axis * f.along) * (-2 * unit)};
}

CurveSample curve_sample(const KernelConstants& kernel, const Circle& ring, const Vec3& p) {
  const double unit = per_support(kernel, ring);
  const Vec3 from = (p - ring.centre) * unit;
  const double z = from.dot(ring.axis);
  const Vec3 across = from - ring.axis * z;
  RingView view{ring.ring_radius * unit, across.length(), 0};
  view.distance2 = rim_distance2(view, z);
  if (!(view.distance2 < 1)) return {};
  const auto f = integral(kernel, view);
  return {f.value, (from * f.whole - across * f.radial) * (-2 * unit)};
}

/// The field grows with the segment's length on either side of the foot and falls with ρ. It is at most the length
/// times the window at the least distance, and at least the length times the window at the greatest.
CurveRange curve_range(const KernelConstants& kernel, const Segment& segment, const Box& box) {
  const double unit = per_support(kernel, segment), length = segment.length * unit;
  AxialRange r(box, segment.a, segment.axis);
  for (double* const each : {&r.x_low, &r.x_high, &r.rho_low, &r.rho_high}) *each *= unit;
  const double beyond = std::max({0.0, -r.x_high, r.x_low - length});
  const double y_least = r.rho_low * r.rho_low + beyond * beyond;
  if (!(y_least < 1)) return {0, 0};
  const double high = std::min(bound(kernel, chord_in(r.rho_low, r.x_high, length - r.x_low), 1),
                               length * window_at(kernel, y_least) * (1 + kRounding));
  double low = 0;
  if (const Chord least = chord_in(r.rho_high, r.x_low, length - r.x_high); r.rho_high < 1 && least.half_length > 0)
    low = bound(kernel, least, -1);
  const double farthest =
      std::max({std::abs(r.x_low), std::abs(r.x_high), std::abs(length - r.x_low), std::abs(length - r.x_high)});
  if (const double y = r.rho_high * r.rho_high + farthest * farthest; y < 1)
    low = std::max(low, length * window_at(kernel, y) * (1 - kRounding));
  return {std::min(low, high), high};
}

/// |p − s|² = d² + 2Rρ(1 − cos φ): the field falls with d and with ρ.
CurveRange curve_range(const KernelConstants& kernel, const Circle& ring, const Box& box) {
  const double unit = per_support(kernel, ring), radius = ring.ring_radius * unit;
  AxialRange r(box, ring.centre, ring.axis);
  for (double* const each : {&r.x_low, &r.x_high, &r.rho_low, &r.rho_high}) *each *= unit;
  const double gap = std::max({0.0, r.rho_low - radius, radius - r.rho_high});
  const double z_near = std::max({0.0, r.x_low, -r.x_high});
  const double y_least = gap * gap + z_near * z_near;
  if (!(y_least < 1)) return {0, 0};
  const double spread = std::max(std::abs(r.rho_high - radius), std::abs(radius - r.rho_low));
  const double z_far = std::max(std::abs(r.x_low), std::abs(r.x_high));
  const double y_most = spread * spread + z_far * z_far;
  const double high = bound(kernel, RingView{radius, r.rho_low, y_least}, 1);
  const double low = y_most < 1 ? bound(kernel, RingView{radius, r.rho_high, y_most}, -1) : 0;
  return {std::min(low, high), high};
}

double curve_most(const KernelConstants& kernel, const Segment& segment, double q) {
  const double y = q * kernel.scale, length = segment.length * per_support(kernel, segment);
  if (!(y < 1)) return 0;
  return std::min(bound(kernel, one::chord_of(y, length, length, length), 1),
                  length * window_at(kernel, y) * (1 + kRounding));
}

/// At a distance d < 1 from the ring, ρ ≥ R − d > R − 1.
double curve_most(const KernelConstants& kernel, const Circle& ring, double q) {
  const double y = q * kernel.scale, radius = ring.ring_radius * per_support(kernel, ring);
  if (!(y < 1)) return 0;
  return std::min(bound(kernel, RingView{radius, std::max(radius - 1, 0.0), y}, 1),
                  2 * kPi * radius * window_at(kernel, y) * (1 + kRounding));
}

double curve_peak(const KernelConstants& kernel, const Segment& segment) {
  const double half = 0.5 * segment.length * per_support(kernel, segment);
  return integral(kernel, one::chord_of(0.0, half, half, half)).value;
}

/// The greatest value is in the ring's plane, between its centre and the ring; it is found by sampling.
double curve_peak(const KernelConstants& kernel, const Circle& ring) {
  const double radius = ring.ring_radius * per_support(kernel, ring);
  double most = 0;
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    RingView view{radius, radius * i / kSteps, 0};
    view.distance2 = rim_distance2(view, 0);
    if (view.distance2 < 1) most = std::max(most, integral(kernel, view).value);
  }
  return most;
}

}  // namespace isl::render
