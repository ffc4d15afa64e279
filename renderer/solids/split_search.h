// Sign changes of a function of one variable that is a difference h = u − v of two functions, each convex or concave on
// the interval: for surfaces that are not algebraic. Reported crossings are certain in the sense of polynomial_roots.h.
//
// A convex function lies above its tangents and below its chords, and its slope grows; so from values and slopes at the
// ends of an interval follow bounds of u and v, hence of h, and h′ ∈ [min u′ − max v′, max u′ − min v′] with the
// extremes at the ends.
//   h bounded away from the other sign            no crossing (by the bounds of u and v, or by the mean value theorem)
//   h within its rounding everywhere              the line lies in the surface, and nothing can be known of it
//   h′ of one sign                                h is monotone: at most one crossing, told by the ends
//   otherwise                                     halve the interval; bounds shrink quadratically, slopes linearly
// down to 2⁻⁵⁰ of the whole, where the ends decide. A slope may be infinite at an end (a root of a distance): the
// bounds from the other end still hold. On an interval that begins on a known root, h monotone there is the deflation:
// there is no other root, and its slope tells the side.
#pragma once

#include "renderer/numerics/goes_on_after.h"
#include "renderer/numerics/rounding_of_noise.h"
#include "renderer/numerics/sign_bracket.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

/// u, v and their slopes at t; `value` has the sign of h, and is certain where |value| > noise.
struct SplitNode {
  double t;
  double u, v, slope_u, slope_v;
  double value, noise;
  double rounding;  ///< where |h| is no more than this, its sign is not certain

  [[nodiscard]] int sign() const { return value > noise ? 1 : (value < -noise ? -1 : 0); }
};

class SplitSearch {
 public:
  /// `sign` is the sign of h before the first interval, or 0 if it is not known.
  explicit SplitSearch(int sign) : sign_(sign) {}
  [[nodiscard]] int sign() const { return sign_; }

  /// `node(t)` is a SplitNode; `u_bends` and `v_bends` are +1 for convex, −1 for concave. crossed(t) is called for
  /// every change of the certain sign in [a, b]; if it returns a bool, false ends the search. With `a_is_root`, the
  /// root at `a` is known and not reported.
  template <class Node, class Crossed>
  void follow(const Node& node, double a, double b, int u_bends, int v_bends, bool a_is_root, Crossed&& crossed) {
    const double shortest = 0x1p-50 * (b - a);
    SplitNode left = node(a);
    FunctionAt certain{a, left.value};
    if (sign_ == 0 && !a_is_root) sign_ = left.sign();
    SplitNode ends[kMostHalvings + 1];
    int top = 0, halvings = 0;
    ends[0] = node(b);
    while (top >= 0) {
      const SplitNode& right = ends[top];
      const double width = right.t - left.t;
      const Range slope = slope_of(left, right);
      const bool is_monotone = slope.low > 0 || slope.high < 0;
      bool is_decided = is_monotone || !(width > shortest);
      if (is_monotone && a_is_root) sign_ = slope.low > 0 ? 1 : -1;
      if (!is_decided) {
        const Range range = bounds_of(left, right, slope, u_bends, v_bends);
        const double rounding = std::max(left.rounding, right.rounding);
        const bool is_clear = (sign_ > 0 && range.low > 0) || (sign_ < 0 && range.high < 0);
        is_decided = (is_clear && !a_is_root) || (range.low >= -rounding && range.high <= rounding);
      }
      if (!is_decided) {
        const double middle = left.t + 0.5 * width;
        if (top < kMostHalvings && middle > left.t && middle < right.t && halvings < kMostInAll) {
          ++halvings;
          ends[++top] = node(middle);
          continue;
        }
      }
      if (const int now = right.sign(); now != 0) {
        if (sign_ != 0 && now != sign_) {
          const auto value = [&](double t) {
            const SplitNode at = node(t);
            return std::abs(at.value) <= kRoundingOfNoise * at.noise ? 0 : at.value;
          };
          const double root = root_in_bracket(value, certain, {right.t, right.value}, sign_);
          if (!goes_on_after(crossed, root)) return;
        }
        sign_ = now;
        certain = {right.t, right.value};
      }
      left = right;
      a_is_root = false;
      --top;
    }
  }

 private:
  static constexpr int kMostHalvings = 60;
  /// The tests make a million searches, and none of them needs 256 halvings. A search that reaches this limit follows
  /// the surface within its noise, or computes with numbers that have overflowed, and would never end.
  static constexpr int kMostInAll = 10000;

  struct Range {
    double low, high;
  };

  [[nodiscard]] static Range slope_of(const SplitNode& a, const SplitNode& b) {
    return {std::min(a.slope_u, b.slope_u) - std::max(a.slope_v, b.slope_v),
            std::max(a.slope_u, b.slope_u) - std::min(a.slope_v, b.slope_v)};
  }

  /// A lower bound on [0, w] of a function above both lines a + s t and b − r (w − t); a line with an infinite slope is
  /// ignored.
  [[nodiscard]] static double least(double a, double s, double b, double r, double w) {
    const bool has_left = std::isfinite(s), has_right = std::isfinite(r);
    if (!has_left && !has_right) return -HUGE_VAL;
    if (!has_left) return r > 0 ? b - r * w : b;
    if (!has_right) return s < 0 ? a + s * w : a;
    if (s >= 0) return std::max(a, b - r * w);
    if (r <= 0) return std::max(b, a + s * w);
    const double meet = std::clamp((b - r * w - a) / (s - r), 0.0, w);
    return std::max(a + s * meet, b - r * (w - meet));
  }

  [[nodiscard]] static Range range_of(double a, double slope_a, double b, double slope_b, double w, int bends) {
    if (bends > 0) return {least(a, slope_a, b, slope_b, w), std::max(a, b)};
    return {std::min(a, b), -least(-a, -slope_a, -b, -slope_b, w)};
  }

  [[nodiscard]] static Range bounds_of(const SplitNode& a, const SplitNode& b, const Range& slope, int u_bends,
                                       int v_bends) {
    const double w = b.t - a.t;
    const Range u = range_of(a.u, a.slope_u, b.u, b.slope_u, w, u_bends);
    const Range v = range_of(a.v, a.slope_v, b.v, b.slope_v, w, v_bends);
    Range h{u.low - v.high, u.high - v.low};
    if (std::isfinite(slope.low) && std::isfinite(slope.high)) {
      const double ha = a.u - a.v, hb = b.u - b.v;
      h.low = std::max(h.low, least(ha, slope.low, hb, slope.high, w));
      h.high = std::min(h.high, -least(-ha, -slope.high, -hb, -slope.low, w));
    }
    return h;
  }

  int sign_;
};

}  // namespace isl::render
