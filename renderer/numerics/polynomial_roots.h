// Finds where polynomials in Bernstein form change sign: all crossings on [0, 1], ascending, each of them certain.
//
// Coefficients are known to within a band E: rounding may have moved each by that much, and therefore every value too
// (a value is a mean of coefficients). A value is certain if |value| > E, and only changes between certain signs are
// reported: a touch, or a pair of roots with less than the band between them, is no crossing. On an interval, where s
// is the last certain sign:
//   s bᵢ ≥ −E for all i                 no value of the other sign is certain: no crossing;
//   from s to −s with one change of sign among s and the certain bᵢ
//                                       exactly one root (Descartes' rule of signs), found in its bracket;
//   |bᵢ| ≤ E for all i                  nothing can be known here;
//   otherwise                           halve it (de Casteljau). Near a simple root one sign change is left after a few
//                                       halvings; a pair of roots is separated or ends in the band.
// An uncertain end, such as a root exactly in the middle, decides nothing: the next certain sign does, and the bracket
// reaches back to the last one. Halving stops at 2⁻⁵⁰, below which t has no digits left; there are at most degree
// intervals to halve at each level, so the work is bounded. NaN is never certain, so it yields nothing.
//
// A ray that starts on the surface has a known root at u = 0: b₀ is set to 0 and u is divided out; the quotient's band
// is n E.
//
// Lane and Riesenfeld 1981 (bounds on a polynomial); Mourrain, Rouillier, Roy 2005 (Bernstein's basis and real root
// isolation).
#pragma once

#include "renderer/numerics/bernstein.h"
#include "renderer/numerics/bernstein_root.h"
#include "renderer/numerics/goes_on_after.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace isl::render {

/// Bound of the rounding of the Bernstein coefficients of a polynomial of this order in the coordinates of a line's
/// point, evaluated by Horner's rule, relative to the same expression with all terms taken as positive. A term passes
/// through at most n products of linear forms (each 3 roundings in two coefficients) and as many sums; halvings add n
/// half units a level of coefficients that halve with the level. 8(n + 2) units of 2⁻⁵³ bound them all.
[[nodiscard]] inline double rounding_of_order(int order) { return 8 * (order + 2) * 0x1p-53; }

/// Follows the sign of a function along a line over consecutive polynomials.
class SignFollower {
 public:
  /// `sign`: the sign of the function before the first polynomial, 0 if it is unknown.
  explicit SignFollower(int sign) : sign_(sign) {}
  /// The last certain sign: +1, −1, or 0 while there was none.
  [[nodiscard]] int sign() const { return sign_; }

  /// Calls crossed(u) for every u in [0, 1] where the sign changes, ascending. `band` is E above. If crossed() returns
  /// a bool, false ends the walk.
  template <class Polynomial, class Crossed>
  void follow(const Polynomial& whole, double band, Crossed&& crossed) {
    bracket(whole, band, [&](double low, double high) { return crossed(root_between(whole, low, high)); });
  }

  /// Calls is_between(low, high) for every such place, which is the only one there.
  template <class Polynomial, class IsBetween>
  void bracket(const Polynomial& whole, double band, IsBetween&& is_between) {
    Part<Polynomial> stack[kMostHalvings + 1];
    int top = 0;
    stack[0] = {whole, 0, 1};
    double certain = 0;  // the last place where the sign was certain, or the beginning
    while (top >= 0) {
      Part<Polynomial>& part = stack[top];
      const Signs signs = signs_of(part.p, band);
      const int right = sign_of(part.p[part.p.degree], band);
      if (sign_ == 0) sign_ = sign_of(part.p[0], band);
      const bool may_cross =
          sign_ > 0 ? signs.negative : (sign_ < 0 ? signs.positive : signs.positive && signs.negative);
      const bool is_decided = !may_cross || (sign_ != 0 && right == -sign_ && changes_once(part.p, band));
      if (!is_decided && part.high - part.low > kShortest) {
        const double middle = 0.5 * (part.low + part.high);
        Part<Polynomial>& left = stack[top + 1];
        left = part;
        halve(left.p, part.p);
        left.high = middle;
        part.low = middle;
        ++top;
        continue;
      }
      if (right != 0) {
        if (sign_ != 0 && right != sign_ && !goes_on_after(is_between, certain, part.high)) return;
        sign_ = right;
        certain = part.high;
      }
      --top;
    }
  }

  /// The only place between these where the sign changes, to the last digit, or until Newton's steps are at most
  /// `enough`.
  template <class Polynomial>
  [[nodiscard]] double root_between(const Polynomial& whole, double low, double high, double enough = 0) const {
    // The value at `low` has the sign sign_ or is not certain, and that at `high` has the opposite sign.
    if (whole.degree == 1) {
      const double root = whole[0] / (whole[0] - whole[1]);
      if (root >= low && root <= high) return root;
    }
    if constexpr (std::is_same_v<Polynomial, FixedBernstein<2>>) {
      const double root = quadratic_root_between(whole, low, high);
      if (root >= low && root <= high) return root;
    }
    return bernstein_root(with_binomials(whole), low, high, sign_, enough);
  }

 private:
  /// The root of b₀(1−u)² + 2b₁u(1−u) + b₂u² between two places, by the quadratic formula in v = u/(1−u), of which the
  /// form is taken that adds terms of the same sign; NaN if rounding moves it out. It is the root of a polynomial whose
  /// coefficients differ by a few roundings.
  [[nodiscard]] static double quadratic_root_between(const FixedBernstein<2>& p, double low, double high) {
    const double q = -(p[1] + std::copysign(std::sqrt(p[1] * p[1] - p[0] * p[2]), p[1]));
    const double first = q / (p[2] + q), second = p[0] / (q + p[0]);  // v/(1 + v) for v = q/b₂ and v = b₀/q
    if (first >= low && first <= high) return first;
    return second;
  }

  static constexpr int kMostHalvings = 52;
  static constexpr double kShortest = 0x1p-50;

  template <class Polynomial>
  struct Part {
    Polynomial p;
    double low, high;
  };
  /// The signs that some coefficient has for certain.
  struct Signs {
    bool positive = false, negative = false;
  };

  [[nodiscard]] static int sign_of(double value, double band) { return value > band ? 1 : (value < -band ? -1 : 0); }

  template <class Polynomial>
  [[nodiscard]] static Signs signs_of(const Polynomial& p, double band) {
    Signs signs;
    for (int i = 0; i <= p.degree; ++i) {
      signs.positive |= p[i] > band;
      signs.negative |= p[i] < -band;
    }
    return signs;
  }

  /// True if the certain coefficients change their sign at most once, beginning with sign_. Precondition: the last one
  /// is certain and of the other sign.
  template <class Polynomial>
  [[nodiscard]] bool changes_once(const Polynomial& p, double band) const {
    bool has_changed = sign_of(p[0], band) != sign_;
    for (int i = 0; i < p.degree; ++i) {
      const int sign = sign_of(p[i], band);
      if (sign == sign_ && has_changed) return false;
      has_changed |= sign == -sign_;
    }
    return true;
  }

  int sign_;
};

}  // namespace isl::render
