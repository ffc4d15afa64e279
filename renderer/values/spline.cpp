#include "renderer/values/spline.h"

#include <algorithm>
#include <cstddef>

namespace isl::values {
namespace {

using scene::Spline;
using scene::SplineKind;
using scene::SplinePoint;
using Terms = std::array<double, 5>;

/// The segment that holds `parameter`: i with points[i] < parameter ≤ points[i + 1]; beyond the ends, the outermost
/// one.
std::size_t segment(const std::vector<SplinePoint>& points, double parameter) {
  const auto at = std::lower_bound(points.begin(), points.end(), parameter,
                                   [](const SplinePoint& point, double value) { return point.parameter < value; });
  const auto i = static_cast<std::size_t>(at - points.begin());
  return std::clamp<std::size_t>(i, 1, points.size() - 1) - 1;
}

double linear(const SplinePoint& a, const SplinePoint& b, double parameter, std::size_t k) {
  const double s = (parameter - a.parameter) / (b.parameter - a.parameter);
  return s * (b.value[k] - a.value[k]) + a.value[k];
}

/// Lagrange's form of the parabola through three points.
double quadratic(const SplinePoint& a, const SplinePoint& b, const SplinePoint& c, double parameter, std::size_t k) {
  const double ab = a.parameter - b.parameter, bc = b.parameter - c.parameter, ca = c.parameter - a.parameter;
  const double ta = parameter - a.parameter, tb = parameter - b.parameter, tc = parameter - c.parameter;
  return -(a.value[k] * tb * tc / (ab * ca) + b.value[k] * ta * tc / (ab * bc) + c.value[k] * ta * tb / (bc * ca));
}

double chord_slope(const SplinePoint& a, const SplinePoint& b, std::size_t k) {
  return (b.value[k] - a.value[k]) / (b.parameter - a.parameter);
}

/// Hermite's form; `p` points at the segment's first point, with one more on either side.
double cubic(const SplinePoint* p, double parameter, std::size_t k) {
  const double length = p[1].parameter - p[0].parameter, s = (parameter - p[0].parameter) / length;
  const double chord = chord_slope(p[0], p[1], k);
  const double slope_0 = (chord_slope(p[-1], p[0], k) + chord) / 2 * length;
  const double slope_1 = (chord + chord_slope(p[1], p[2], k)) / 2 * length;
  const double rise = p[1].value[k] - p[0].value[k];
  return ((s * (slope_0 + slope_1 - 2 * rise) + (3 * rise - 2 * slope_0 - slope_1)) * s + slope_0) * s + p[0].value[k];
}

double natural(const SplinePoint& a, const SplinePoint& b, double parameter, std::size_t k) {
  const double h = b.parameter - a.parameter, s = (b.parameter - parameter) / h, t = (parameter - a.parameter) / h;
  return s * a.value[k] + t * b.value[k] +
         ((s * s * s - s) * a.bending[k] + (t * t * t - t) * b.bending[k]) * (h * h) / 6;
}

/// Second derivatives at the points: solves the tridiagonal system of the natural spline by elimination.
void bend(std::vector<SplinePoint>& points, std::size_t k) {
  const std::size_t count = points.size();
  points.front().bending[k] = points.back().bending[k] = 0;
  std::vector<double> upper(count, 0.0), right(count, 0.0);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double before = points[i].parameter - points[i - 1].parameter;
    const double after = points[i + 1].parameter - points[i].parameter;
    const double jump = 6 * (chord_slope(points[i], points[i + 1], k) - chord_slope(points[i - 1], points[i], k));
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    right[i] = (jump - before * right[i - 1]) / pivot;
  }
  for (std::size_t i = count - 1; i-- > 1;) points[i].bending[k] = right[i] - upper[i] * points[i + 1].bending[k];
}

}  // namespace

Terms evaluate(const Spline& spline, SplineKind kind, double parameter) noexcept {
  const std::vector<SplinePoint>& points = spline.points;
  const std::size_t last = points.size() - 1;
  if (last == 0) return points[0].value;
  // A cubic spline of two points has no segment. POV-Ray returns the mean of the points, whatever the parameter.
  const bool is_cubic = kind == SplineKind::cubic;
  if (is_cubic && last == 1) {
    Terms mean{};
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = (points[0].value[k] + points[1].value[k]) / 2;
    return mean;
  }
  const std::size_t begin = is_cubic ? 1 : 0, end = is_cubic ? last - 1 : last;
  if (parameter <= points[begin].parameter) return points[begin].value;
  if (!(parameter < points[end].parameter)) return points[end].value;
  const std::size_t i = segment(points, parameter);
  Terms terms{};
  const auto count = static_cast<std::size_t>(spline.term_count);
  for (std::size_t k = 0; k < count; ++k) {
    switch (kind) {
      case SplineKind::linear: terms[k] = linear(points[i], points[i + 1], parameter, k); break;
      case SplineKind::quadratic: {
        const std::size_t first = last == 1 ? 0 : i == 0 ? 0 : i - 1;
        terms[k] = last == 1 ? linear(points[0], points[1], parameter, k)
                             : quadratic(points[first], points[first + 1], points[first + 2], parameter, k);
        break;
      }
      case SplineKind::cubic: terms[k] = cubic(&points[i], parameter, k); break;
      case SplineKind::natural: terms[k] = natural(points[i], points[i + 1], parameter, k); break;
    }
  }
  return terms;
}

void insert(Spline& spline, double parameter, const Terms& value) {
  std::vector<SplinePoint>& points = spline.points;
  const auto at = std::lower_bound(points.begin(), points.end(), parameter,
                                   [](const SplinePoint& point, double wanted) { return point.parameter < wanted; });
  if (at == points.end() || at->parameter != parameter) {
    points.insert(at, {.parameter = parameter, .value = value});
  } else if (at == points.begin() || at + 1 != points.end()) {
    at->value = value;
  }
}

void finish(Spline& spline) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(spline.term_count); ++k) bend(spline.points, k);
}

}  // namespace isl::values
