#include "renderer/solids/outline.h"

#include "renderer/solids/plane_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace isl::render {
namespace {

using scene::Outline;

/// A form on a curve.
template <std::size_t kPoints>
using OnCurve = FixedBernstein<static_cast<int>(kPoints) - 1>;

int sign_of(double value, double band) { return value > band ? 1 : (value < -band ? -1 : 0); }

template <std::size_t kPoints>
OnCurve<kPoints> on_curve(const LinearForm& form, CurveOf<kPoints> curve, double& band) {
  OnCurve<kPoints> values;
  double size = 0;
  for (int i = 0; i <= values.degree; ++i) {
    const PlanePoint& p = curve[static_cast<std::size_t>(i)];
    values[i] = form.at(p);
    size = std::max(size, form.size_at(p));
  }
  band = rounding_of_order(values.degree) * size;
  return values;
}

int sign_at(const LinearForm& form, const PlanePoint& p) {
  return sign_of(form.at(p), rounding_of_order(1) * form.size_at(p));
}

/// The only root on [0, 1] of a line or quadratic whose ends have opposite signs. With x = w/(1 − w) the quadratic is
/// b₂x² + 2b₁x + b₀, and b₁² − b₀b₂ is a sum of two positive numbers: nothing cancels. NaN if that sum overflows or
/// loses digits to underflow.
double root_between_ends(const FixedBernstein<1>& p) { return p[0] / (p[0] - p[1]); }
double root_between_ends(const FixedBernstein<2>& p) {
  const double square = p[1] * p[1] - p[0] * p[2];
  if (!(square > 0x1p-960 && square < 0x1p1000)) return std::numeric_limits<double>::quiet_NaN();
  const double q = p[1] + std::copysign(std::sqrt(square), p[1]);
  // The roots are −q/b₂ and −b₀/q, and one of them is positive.
  const bool is_first = (q > 0) != (p[2] > 0);
  return is_first ? q / (q - p[2]) : p[0] / (p[0] - q);
}

/// Follows the form along one curve; crossed(crossing) for each change of sign.
template <std::size_t kPoints, class Crossed>
void follow_curve(SignFollower& follower, const LinearForm& form, CurveOf<kPoints> curve, Crossed&& crossed) {
  double band = 0;
  const OnCurve<kPoints> values = on_curve(form, curve, band);
  const auto at = [&](double w) { crossed(OutlineCrossing{.point = point_at(curve, w), .turn = -follower.sign()}); };
  if constexpr (kPoints <= 3) {
    // Most crossings are of this kind.
    const int last = sign_of(values[values.degree], band);
    if (last != 0 && follower.sign() == -last && sign_of(values[0], band) == -last) {
      if (const double w = root_between_ends(values); w >= 0 && w <= 1) {
        at(w);
        follower = SignFollower(last);
        return;
      }
    }
  }
  follower.follow(values, band, at);
}

/// Splits at w: `p` becomes the part below it, the result is that above.
template <int n>
FixedBernstein<n> split(FixedBernstein<n>& p, double w) {
  FixedBernstein<n> above;
  above[n] = p[n];
  for (int level = 1; level <= n; ++level) {
    for (int i = n; i >= level; --i) p[i] = p[i - 1] * (1 - w) + p[i] * w;
    above[n - level] = p[n];
  }
  return above;
}

/// The quotient of p, which is 0 at w, by the distance from there. Its coefficients follow from
/// n bᵢ = i (1 − w) hᵢ₋₁ − (n − i) w hᵢ, from the end that is farther from w: then no coefficient is divided by less
/// than ½, and an error E of those of p becomes at most (2ⁿ⁺¹ − 2) E.
template <int n>
FixedBernstein<n - 1> over_distance(const FixedBernstein<n>& p, double w) {
  FixedBernstein<n - 1> h;
  if (w <= 0.5) {
    double known = 0;
    for (int i = n; i > 0; --i) h[i - 1] = known = (n * p[i] + (n - i) * w * known) / (i * (1 - w));
  } else {
    double known = 0;
    for (int i = 0; i < n; ++i) h[i] = known = (i * (1 - w) * known - n * p[i]) / ((n - i) * w);
  }
  return h;
}

/// Follows the form along a curve with a known zero. The form is the distance from there times a quotient, so that its
/// signs are those of the quotient, turned before the zero. If both sides have the same sign next to the zero, it is a
/// touch, or one of two zeros that are closer than rounding: both are left out.
template <std::size_t kPoints, class Crossed>
void follow_from_zero(SignFollower& follower, const LinearForm& form, CurveOf<kPoints> curve, const OutlinePlace& zero,
                      Crossed&& crossed) {
  if (kPoints == 2) {  // the quotient is the line's slope
    const PlanePoint along = curve[1] - curve[0];
    const int sign = sign_of(form.along(along), rounding_of_order(1) * form.size_along(along));
    if (sign != 0 && follower.sign() != sign) {
      crossed(OutlineCrossing{.point = zero.point, .turn = sign, .is_start = true});
      follower = SignFollower(sign);
      return;
    }
  }
  // Values relative to the zero keep their digits near it.
  OnCurve<kPoints> values;
  constexpr int n = static_cast<int>(kPoints) - 1;
  double size = 0;
  for (int i = 0; i <= n; ++i) {
    const PlanePoint step = curve[static_cast<std::size_t>(i)] - zero.point;
    values[i] = form.along(step);
    size = std::max(size, form.size_along(step));
  }
  const double band = rounding_of_order(n) * size * ((2 << n) - 2);
  FixedBernstein<n - 1> below = over_distance(values, zero.w);
  const FixedBernstein<n - 1> above = split(below, zero.w);
  for (int i = 0; i < n; ++i) below[i] = -below[i];
  const auto at = [&](double w, int turn) { crossed(OutlineCrossing{.point = point_at(curve, w), .turn = turn}); };
  follower.follow(below, band, [&](double u) { at(u * zero.w, -follower.sign()); });
  const int before = follower.sign();
  SignFollower rest(0);
  std::array<double, kMostPoints> beyond;
  std::size_t count = 0;
  rest.follow(above, band, [&](double u) { beyond[count++] = zero.w + u * (1 - zero.w); });
  if (rest.sign() == 0) return;
  // Each crossing beyond the zero changes the sign once.
  int sign = count % 2 == 0 ? rest.sign() : -rest.sign();
  if (before != 0 && before != sign) crossed(OutlineCrossing{.point = zero.point, .turn = sign, .is_start = true});
  for (std::size_t i = 0; i < count; ++i) at(beyond[i], sign = -sign);
  follower = rest;
}

/// Follows the form around a contour: walk(follower, crossed) passes along all of its curves. If the sign at the
/// beginning is uncertain, it is that at the end.
template <class Walk, class Crossed>
void follow_contour(const LinearForm& form, const PlanePoint& begin, Walk&& walk, Crossed&& crossed) {
  int sign = sign_at(form, begin);
  if (sign == 0) {
    SignFollower ahead(0);
    walk(ahead, [](const OutlineCrossing&) {});
    sign = ahead.sign();
  }
  SignFollower follower(sign);
  walk(follower, crossed);
}

/// True if no value of the form in the box has the sign opposite to `sign`. Rounding is monotone, so that this holds
/// for the rounded values at points of the box, too.
bool is_on_side(const LinearForm& form, const OutlineNode& node, int sign) {
  if (sign == 0) return false;
  const bool wants_low = sign > 0;
  const PlanePoint worst{(form.u > 0) == wants_low ? node.low.u : node.high.u,
                         (form.v > 0) == wants_low ? node.low.v : node.high.v};
  return sign > 0 ? form.at(worst) >= 0 : form.at(worst) <= 0;
}

bool meets(const OutlineNode& node, const PlaneWindow& window) {
  return node.low.u <= window.high.u && node.high.u >= window.low.u && node.low.v <= window.high.v &&
         node.high.v >= window.low.v;
}

}  // namespace

void find_crossings(const PreparedOutline& outline, const LinearForm& form, std::vector<OutlineCrossing>& crossings,
                    const PlaneWindow& window, const OutlinePlace* start) {
  const auto keep = [&](const OutlineCrossing& crossing) { crossings.push_back(crossing); };
  for (std::uint32_t root = 0; root < outline.nodes.size(); root = outline.nodes[root].next) {
    if (!meets(outline.nodes[root], window)) continue;
    const auto walk = [&](SignFollower& follower, auto&& crossed) {
      for (std::uint32_t i = root; i < outline.nodes[root].next;) {
        const OutlineNode& node = outline.nodes[i];
        if (is_on_side(form, node, follower.sign())) {
          i = node.next;
          continue;
        }
        if (node.order > 0) {
          const Curve curve = curve_of(outline.outline, node);
          const auto crossed_here = [&](OutlineCrossing crossing) {
            crossing.node = i;
            crossed(crossing);
          };
          with_order(curve, [&](auto of_order) {
            if (start && start->node == i) {
              follow_from_zero(follower, form, of_order, *start, crossed_here);
            } else {
              follow_curve(follower, form, of_order, crossed_here);
            }
          });
        }
        ++i;
      }
    };
    std::uint32_t first = root;
    while (outline.nodes[first].order == 0) ++first;
    follow_contour(form, outline.outline.points[outline.nodes[first].first], walk, keep);
  }
}

void find_crossings(const Outline& outline, const LinearForm& form, std::vector<OutlineCrossing>& crossings) {
  const auto keep = [&](const OutlineCrossing& crossing) { crossings.push_back(crossing); };
  std::size_t first_curve = 0, first_point = 0;
  for (const std::uint32_t count : outline.contours) {
    std::size_t end_point = first_point;
    const auto walk = [&](SignFollower& follower, auto&& crossed) {
      end_point = first_point;
      for (std::size_t i = first_curve; i < first_curve + count; ++i) {
        const Curve curve = std::span(outline.points).subspan(end_point, outline.orders[i] + std::size_t{1});
        with_order(curve, [&](auto of_order) { follow_curve(follower, form, of_order, crossed); });
        end_point += outline.orders[i];
      }
    };
    follow_contour(form, outline.points[first_point], walk, keep);
    first_curve += count;
    first_point = end_point + 1;
  }
}

namespace {

/// Counts the crossings, which are those of a line along u, with the half-line from the point on.
bool is_in(const Outline& outline, const PlanePoint& point, const std::vector<OutlineCrossing>& crossings) {
  OutlineFill fill(outline);
  for (const OutlineCrossing& crossing : crossings) {
    if (crossing.point.u > point.u) fill.pass(crossing);
  }
  return fill.is_inside();
}

}  // namespace

bool contains(const PreparedOutline& outline, const PlanePoint& point) {
  std::vector<OutlineCrossing> crossings;
  find_crossings(outline, LinearForm::of_line(point, {1, 0}), crossings, {point, point});
  return is_in(outline.outline, point, crossings);
}

bool contains(const Outline& outline, const PlanePoint& point) {
  std::vector<OutlineCrossing> crossings;
  find_crossings(outline, LinearForm::of_line(point, {1, 0}), crossings);
  return is_in(outline, point, crossings);
}

}  // namespace isl::render
