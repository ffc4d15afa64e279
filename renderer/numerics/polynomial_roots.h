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
#include "renderer/numerics/sign_bracket.h"

#include <cmath>
#include <limits>

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

  /// Calls crossed(u) for every u in [0, 1] where the sign changes, ascending. `band` is E above.
  template <class Crossed>
  void follow(const Bernstein& whole, double band, Crossed&& crossed) {
    Part stack[kMostHalvings + 1];
    int top = 0;
    stack[0] = {whole, 0, 1};
    double certain = 0;  // the last place where the sign was certain, or the beginning
    while (top >= 0) {
      Part& part = stack[top];
      const Shape shape = shape_of(part.p, band);
      const int n = part.p.degree;
      const int right = sign_of(part.p[n], band);
      if (sign_ == 0) sign_ = sign_of(part.p[0], band);
      const bool may_cross = sign_ > 0 ? shape.has_negative : (sign_ < 0 ? shape.has_positive : shape.has_both());
      const bool changes_once = shape.changes == 0 || (shape.changes == 1 && sign_of(part.p[0], band) == sign_);
      const bool is_decided = !may_cross || (sign_ != 0 && right == -sign_ && changes_once);
      if (!is_decided && part.high - part.low > kShortest && (shape.has_positive || shape.has_negative)) {
        const double middle = 0.5 * (part.low + part.high);
        Part& left = stack[top + 1];
        left = part;
        halve(left.p, part.p);
        left.high = middle;
        part.low = middle;
        ++top;
        continue;
      }
      if (right != 0) {
        if (sign_ != 0 && right != sign_) crossed(root_between(whole, certain, part.high));
        sign_ = right;
        certain = part.high;
      }
      --top;
    }
  }

 private:
  static constexpr int kMostHalvings = 52;
  static constexpr double kShortest = 0x1p-50;

  struct Part {
    Bernstein p;
    double low, high;
  };
  /// The signs of the certain coefficients.
  struct Shape {
    bool has_positive = false, has_negative = false;
    int changes = 0;
    [[nodiscard]] bool has_both() const { return has_positive && has_negative; }
  };

  [[nodiscard]] static int sign_of(double value, double band) { return value > band ? 1 : (value < -band ? -1 : 0); }

  [[nodiscard]] static Shape shape_of(const Bernstein& p, double band) {
    Shape shape;
    int last = 0;
    for (int i = 0; i <= p.degree; ++i) {
      const int sign = sign_of(p[i], band);
      if (sign == 0) continue;
      (sign > 0 ? shape.has_positive : shape.has_negative) = true;
      if (last != 0 && sign != last) ++shape.changes;
      last = sign;
    }
    return shape;
  }

  /// Precondition: the value at `low` has the sign sign_ or is not certain, and that at `high` has the opposite sign.
  [[nodiscard]] double root_between(const Bernstein& p, double low, double high) const {
    return root_in_bracket([&](double u) { return value_at(p, u); }, low, high, sign_);
  }

  int sign_;
};

}  // namespace isl::render
