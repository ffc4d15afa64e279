// A point of the box that is inside the quadric satisfies, for each coordinate x, a x² + b x + r ≤ 0, where b and r are
// the values of polynomials in the other two coordinates. The box bounds these: b lies in an interval, and r is no less
// than some R. For a > 0 that bounds x on both sides, and for a = 0 on the one that b points away from. So a cylinder
// between two planes, a cone or a paraboloid up to one, have finite boxes, although none of their parts has.
// (Benhamou et al. 1999, Revising hull and box consistency.)
//
// Every coefficient is an interval that rounding cannot leave, so that what is computed from its ends needs no other
// care: the interval is 2⁹ half units in the last place wide of the sum of what was added, sixteen products of three
// factors at most; this leaves as much for the sums and products that follow.
#include "renderer/extents/quadric_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace isl::render {
namespace {

using scene::Matrix;

constexpr double kRounding = 0x1p-44;
constexpr double kEndless = std::numeric_limits<double>::infinity();

struct Interval {
  double low, high;

  [[nodiscard]] bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
};

Interval operator+(const Interval& a, const Interval& b) { return {a.low + b.low, a.high + b.high}; }
Interval operator*(double factor, const Interval& a) { return {factor * a.low, factor * a.high}; }  // of factors ≥ 0

/// The product, with 0 · ∞ = 0: an infinite side is one that is not known.
Interval operator*(const Interval& a, const Interval& b) {
  const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const auto [low, high] =
      std::minmax({product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
  return {low, high};
}

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

std::optional<Interval> common(const Interval& a, const Interval& b) {
  const Interval both{std::max(a.low, b.low), std::min(a.high, b.high)};
  return both.low <= both.high ? std::optional(both) : std::nullopt;
}

/// The least of a x² + b x for x in the interval, no side of which is beyond 0 from the other.
double least_on_one_side(double a, double b, const Interval& x) {
  const auto at = [&](double t) { return t == 0 ? 0 : (a * t + b) * t; };
  if (a > 0) return at(std::clamp(-b / (2 * a), x.low, x.high));
  const auto at_end = [&](double t) {
    if (std::isfinite(t)) return at(t);
    if (a == 0 && b == 0) return 0.0;
    return a < 0 || b * t < 0 ? -kEndless : kEndless;
  };
  return std::min(at_end(x.low), at_end(x.high));
}

double least_of(const Interval& a, const Interval& b, const Interval& x) {
  double least = kEndless;
  if (const auto right = common(x, {0, kEndless})) least = std::min(least, least_on_one_side(a.low, b.low, *right));
  if (const auto left = common(x, {-kEndless, 0})) least = std::min(least, least_on_one_side(a.low, b.high, *left));
  return least;
}

/// The interval of x in which a x² + b x + r ≤ 0, for a ≥ 0; empty if there is none.
std::optional<Interval> not_above_zero(double a, double b, double r) {
  const auto wider = [](double low, double high) {
    return Interval{low - kRounding * std::abs(low), high + kRounding * std::abs(high)};
  };
  if (a == 0) {
    if (b == 0) return r > 0 ? std::nullopt : std::optional(Interval{-kEndless, kEndless});
    const Interval end = wider(-r / b, -r / b);
    return b > 0 ? Interval{-kEndless, end.high} : Interval{end.low, kEndless};
  }
  const double low_r = r - kRounding * (std::abs(r) + b * b / (4 * a));
  const double discriminant = b * b - 4 * a * low_r;
  if (discriminant < 0) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  if (q == 0) return Interval{0, 0};
  const auto [low, high] = std::minmax({q / a, low_r / q});
  return wider(low, high);
}

/// The symmetric form S with P(x, y, z) = (x, y, z, 1) S (x, y, z, 1)ᵀ, in the space of the box.
class Form {
 public:
  Form(const scene::Polynomial& quadric, const scene::Transform& box_from_quadric) {
    const std::vector<double>& c = quadric.coefficients;
    const Matrix own(c[0], c[1] / 2, c[2] / 2, c[3] / 2, c[1] / 2, c[4], c[5] / 2, c[6] / 2, c[2] / 2, c[5] / 2, c[7],
                     c[8] / 2, c[3] / 2, c[6] / 2, c[8] / 2, c[9]);
    form_ = box_from_quadric.inverse * own * box_from_quadric.inverse.transposed();
    const Matrix sizes = without_signs(box_from_quadric.inverse);
    sizes_ = sizes * without_signs(own) * sizes.transposed();
  }
  [[nodiscard]] Interval operator()(int i, int j) const {
    const double rounding = kRounding * sizes_[i][j];
    return {form_[i][j] - rounding, form_[i][j] + rounding};
  }

 private:
  static Matrix without_signs(Matrix matrix) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) matrix[i][j] = std::abs(matrix[i][j]);
    }
    return matrix;
  }

  Matrix form_;
  Matrix sizes_;  ///< sums of the sizes of what was added
};

/// The interval of one coordinate, given the others'; nothing if the box is outside.
std::optional<Interval> narrowed(const Form& form, const std::array<Interval, 3>& box, int axis) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Interval a = form(axis, axis);
  const Interval b = 2 * (form(axis, 3) + form(axis, j) * box[j] + form(axis, k) * box[k]);
  const double r = least_of(form(j, j), 2 * form(j, 3), box[j]) + least_of(form(k, k), 2 * form(k, 3), box[k]) +
                   (2 * (form(j, k) * (box[j] * box[k]))).low + form(3, 3).low;
  if (a.low < 0 || !b.is_finite() || !std::isfinite(r)) return box[axis];
  // The least of b counts where x > 0, and the greatest where x < 0.
  std::optional<Interval> right = not_above_zero(a.low, b.low, r), left = not_above_zero(a.low, b.high, r);
  if (right) right = common(*right, {0, kEndless});
  if (left) left = common(*left, {-kEndless, 0});
  if (!right && !left) return std::nullopt;
  return common(box[axis], hull(right.value_or(*left), left.value_or(*right)));
}

}  // namespace

Imath::Box3d narrowed_by_quadric(const Imath::Box3d& box, const scene::Polynomial& quadric,
                                 const scene::Transform& box_from_quadric) {
  if (box.isEmpty()) return box;
  const Form form(quadric, box_from_quadric);
  std::array<Interval, 3> sides;
  for (int i = 0; i < 3; ++i) sides[i] = {box.min[i], box.max[i]};
  // Each axis may bound the next: twice round, whichever is bounded first.
  for (int i = 0; i < 6; ++i) {
    const std::optional<Interval> side = narrowed(form, sides, i % 3);
    if (!side) return {};
    sides[i % 3] = *side;
  }
  return {{sides[0].low, sides[1].low, sides[2].low}, {sides[0].high, sides[1].high, sides[2].high}};
}

}  // namespace isl::render
