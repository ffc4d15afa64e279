// Bézier curves of the orders 1 to 3 in a plane, by their control points.
#pragma once

#include "renderer/numerics/polynomial_roots.h"
#include "renderer/solids/solid_details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace isl::render {

[[nodiscard]] inline PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a.u + b.u, a.v + b.v}; }
[[nodiscard]] inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a.u - b.u, a.v - b.v}; }
[[nodiscard]] inline PlanePoint operator*(const PlanePoint& a, double factor) { return {a.u * factor, a.v * factor}; }
[[nodiscard]] inline double dot(const PlanePoint& a, const PlanePoint& b) { return a.u * b.u + a.v * b.v; }

/// The control points of a curve; one more than its order.
using Curve = std::span<const PlanePoint>;

inline constexpr int kMostPoints = 4;

/// The control points of a curve whose order the compiler knows, so that loops over them are none.
template <std::size_t kPoints>
using CurveOf = std::span<const PlanePoint, kPoints>;

/// Calls use(CurveOf) and returns its result.
template <class Use>
decltype(auto) with_order(Curve curve, const Use& use) {
  if (curve.size() == 2) return use(curve.first<2>());
  if (curve.size() == 3) return use(curve.first<3>());
  return use(curve.first<4>());
}

/// The points of de Casteljau's scheme at w where it has two left; they are on the tangent.
template <std::size_t kPoints>
[[nodiscard]] std::array<PlanePoint, 2> last_two(CurveOf<kPoints> curve, double w) {
  std::array<PlanePoint, kPoints> points;
  std::ranges::copy(curve, points.begin());
#pragma GCC unroll 4
  for (std::size_t left = kPoints - 1; left > 1; --left) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < left; ++i) points[i] = points[i] * (1 - w) + points[i + 1] * w;
  }
  return {points[0], points[1]};
}
[[nodiscard]] inline std::array<PlanePoint, 2> last_two(Curve curve, double w) {
  return with_order(curve, [w](auto of_order) { return last_two(of_order, w); });
}

[[nodiscard]] inline PlanePoint point_at(Curve curve, double w) {
  if (w == 1) return curve.back();
  const auto [a, b] = last_two(curve, w);
  return a * (1 - w) + b * w;
}

/// A direction along the curve. At a cusp, and where control points coincide, it is that to the curve's far end.
[[nodiscard]] inline PlanePoint tangent_at(Curve curve, double w) {
  const auto [a, b] = last_two(curve, w);
  const PlanePoint along = b - a;
  if (along != PlanePoint{}) return along * static_cast<double>(curve.size() - 1);
  return w < 0.5 ? curve.back() - point_at(curve, w) : point_at(curve, w) - curve.front();
}

/// Calls at(w) where the distance from p to the curve may be least: at both ends, and where the derivative of half its
/// square, (P − p)·P′, changes its sign.
template <class At>
void for_each_foot(Curve curve, const PlanePoint& p, At&& at) {
  const int n = static_cast<int>(curve.size()) - 1;
  BernsteinUpTo<2 * kMostPoints - 3> slope;
  slope.degree = 2 * n - 1;
  double size = 0;
  for (int k = 0; k <= slope.degree; ++k) {
    double sum = 0, terms = 0;
    for (int i = std::max(0, k - n + 1); i <= std::min(n, k); ++i) {
      const PlanePoint from = curve[static_cast<std::size_t>(i)] - p;
      const auto j = static_cast<std::size_t>(k - i);
      const PlanePoint along = curve[j + 1] - curve[j];
      const double weight = binomial(n, i) * binomial(n - 1, k - i) / binomial(2 * n - 1, k);
      sum += weight * dot(from, along);
      terms += weight * (std::abs(from.u * along.u) + std::abs(from.v * along.v));
    }
    slope[k] = sum;
    size = std::max(size, terms);
  }
  at(0.0);
  SignFollower follower(0);
  follower.follow(slope, rounding_of_order(slope.degree) * size, at);
  at(1.0);
}

/// The w in [0, 1] that is nearest to p on a line, or on a curve that passes through p up to rounding; none for other
/// points, and where Gauss's and Newton's steps along the tangent do not end in a few.
template <std::size_t kPoints>
[[nodiscard]] std::optional<double> foot_on_curve(CurveOf<kPoints> curve, const PlanePoint& p) {
  const PlanePoint chord = curve.back() - curve.front();
  const double square = dot(chord, chord);
  if (!(square > 0)) return std::nullopt;
  double w = std::clamp(dot(p - curve.front(), chord) / square, 0.0, 1.0);
  if (kPoints == 2) return w;
  constexpr int kMostSteps = 6;
  constexpr double kLastStep = 0x1p-50;  // below which w has no digits left
  // Points that are computed as lying on the curve are off by some units of 2⁻⁵², with transforms by some more.
  const double near = 0x1p-44 * (std::abs(p.u) + std::abs(p.v));
  for (int i = 0; i < kMostSteps; ++i) {
    const auto [a, b] = last_two(curve, w);
    const PlanePoint tangent = (b - a) * static_cast<double>(kPoints - 1), from = a * (1 - w) + b * w - p;
    const double step = dot(from, tangent) / dot(tangent, tangent);
    w -= step;
    if (!(w >= 0 && w <= 1)) return std::nullopt;
    if (std::abs(step) <= kLastStep) {
      if (dot(from, from) <= near * near) return w;
      return std::nullopt;
    }
  }
  return std::nullopt;
}

[[nodiscard]] inline std::optional<double> foot_on_curve(Curve curve, const PlanePoint& p) {
  return with_order(curve, [&](auto of_order) { return foot_on_curve(of_order, p); });
}

/// Calls at(w) where direction · P may be greatest: at both ends, and where its slope changes its sign.
template <class At>
void for_each_farthest(Curve curve, const PlanePoint& direction, At&& at) {
  at(0.0);
  at(1.0);
  if (curve.size() == 2) return;
  BernsteinUpTo<kMostPoints - 2> slope;
  slope.degree = static_cast<int>(curve.size()) - 2;
  double size = 0;
  for (int k = 0; k <= slope.degree; ++k) {
    const PlanePoint along = curve[static_cast<std::size_t>(k) + 1] - curve[static_cast<std::size_t>(k)];
    slope[k] = dot(along, direction);
    size = std::max(size, std::abs(along.u * direction.u) + std::abs(along.v * direction.v));
  }
  SignFollower follower(0);
  follower.follow(slope, rounding_of_order(slope.degree) * size, at);
}

}  // namespace isl::render
