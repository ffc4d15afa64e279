// quadric, cubic, quartic, poly: where a polynomial P(x, y, z) of order n is ≤ 0.
//
// Along a line P is a polynomial of one variable over an unbounded stretch. It is followed over three pieces on which
// it is one over [0, 1] and nothing grows beyond bounds (P made homogeneous, P̂(x, y, z, w) = wⁿ P(x/w, y/w, z/w)):
//
//      ──────── −h/v ────────┤├──── foot ± h ────┤├──────── h/v ────────
//
// the middle one about the line's foot, its point nearest to the origin; beyond, t = foot ± h/v with v in (0, 1], where
// v·p(t) is linear in v and v = 0 is infinity. h is the larger of the foot's distance and the polynomial's own reach
// (PreparedPolynomial), so that on every piece all terms are at most of the size that they have near the surface; and
// everything is divided by h, so that no power overflows. Only what lies beyond t = 0 is followed.
//
// On a piece the coordinates and w are linear forms l₀(1−u) + l₁u. Horner's rule for polynomials in three variables, on
// sums Σ cᵢ (1−u)ᵏ⁻ⁱ uⁱ, needs products with linear forms, which are convolutions, and sums of one degree, since a
// term's missing order is made up for by powers of w. The cᵢ over binomials are the Bernstein coefficients: no change
// of basis, no shift, nothing cancels that the polynomial itself does not cancel. Horner's rule with absolute values
// bounds the rounding (polynomial_roots.h, which finds the sign changes).
//
// If a cube that contains the inside is known (polynomial_bound.h), the line's part within it is the only piece.
//
// If only a stretch of the line is asked for, and is no longer than the pieces' sizes allow, it is the only piece. The
// polynomial's sign must be certain at both of its ends: a crossing that is not wholly inside would be lost otherwise.
//
// A ray that starts on the surface begins the first piece at its own origin, where the coefficient is 0: divided out.
#include "renderer/solids/polynomial.h"

#include "renderer/numerics/polynomial_roots.h"
#include "renderer/numerics/power.h"
#include "renderer/solids/polynomial_bound.h"
#include "renderer/solids/quadric_line.h"
#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace isl::render {
namespace {

/// l₀(1−u) + l₁u.
struct LinearForm {
  double l0, l1;
  [[nodiscard]] double largest() const { return std::max(std::abs(l0), std::abs(l1)); }
};

struct Piece {
  LinearForm x, y, z, w;
};

/// Σ cᵢ (1−u)ᵏ⁻ⁱ uⁱ, or zero, of any degree (degree −1): most coefficients of usual polynomials are zero.
struct Scaled {
  int degree = -1;
  std::array<double, kMostDegree + 1> c;

  [[nodiscard]] bool is_zero() const { return degree < 0; }
  void multiply(const LinearForm& l) {
    if (is_zero()) return;
    c[static_cast<std::size_t>(degree) + 1] = l.l1 * c[static_cast<std::size_t>(degree)];
    for (auto i = static_cast<std::size_t>(degree); i > 0; --i) c[i] = l.l0 * c[i] + l.l1 * c[i - 1];
    c[0] *= l.l0;
    ++degree;
  }
  void add_times(double factor, const Scaled& other) {
    if (factor == 0 || other.is_zero()) return;
    const auto count = static_cast<std::size_t>(other.degree) + 1;
    if (is_zero()) {
      degree = other.degree;
      for (std::size_t i = 0; i < count; ++i) c[i] = factor * other.c[i];
    } else {
      for (std::size_t i = 0; i < count; ++i) c[i] += factor * other.c[i];
    }
  }
};

/// Σ cᵢ (1−u)ᵏ⁻ⁱ uⁱ of a degree k ≤ n, with zeros behind.
template <int n>
struct SmallScaled {
  bool is_zero = true;
  std::array<double, n + 1> c{};

  void multiply(const LinearForm& l) {
    if (is_zero) return;
    for (auto i = static_cast<std::size_t>(n); i > 0; --i) c[i] = l.l0 * c[i] + l.l1 * c[i - 1];
    c[0] *= l.l0;
  }
  void add_times(double factor, const SmallScaled& other) {
    if (factor == 0 || other.is_zero) return;
    is_zero = false;
    for (std::size_t i = 0; i <= n; ++i) c[i] += factor * other.c[i];
  }
};

/// P̂ along a piece, for an order that the compiler knows.
template <int n>
FixedBernstein<n> along(const PreparedPolynomial& polynomial, const Piece& piece) {
  using Sum = SmallScaled<n>;
  std::array<Sum, n + 1> powers_of_w;
  powers_of_w[0].is_zero = false;
  powers_of_w[0].c[0] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    powers_of_w[k] = powers_of_w[k - 1];
    powers_of_w[k].multiply(piece.w);
  }
  const double* coefficient = polynomial.coefficients.data();
  Sum in_x;
  for (int i = 0; i <= n; ++i) {
    Sum in_y;
    for (int j = 0; j <= i; ++j) {
      Sum in_z;
      for (std::size_t k = 0; k <= static_cast<std::size_t>(j); ++k) {
        in_z.multiply(piece.z);
        in_z.add_times(*coefficient++, powers_of_w[k]);
      }
      in_y.multiply(piece.y);
      in_y.add_times(1, in_z);
    }
    in_x.multiply(piece.x);
    in_x.add_times(1, in_y);
  }
  FixedBernstein<n> result;
  for (int i = 0; i <= n; ++i) result[i] = in_x.c[static_cast<std::size_t>(i)] / binomial(n, i);
  return result;
}

/// A point of a piece, (x, y, z, w).
struct HomogeneousPoint {
  double x, y, z, w;
};

/// XᵀMY of the quadratic form P̂(X) = XᵀMX, or the same with all coefficients as positive. Each term takes 4 roundings
/// and is added 9 times, which are fewer than rounding_of_order(2) stands for.
template <bool is_absolute>
double polar(const std::vector<double>& coefficients, const HomogeneousPoint& a, const HomogeneousPoint& b) {
  const auto c = [&](std::size_t i) { return is_absolute ? std::abs(coefficients[i]) : coefficients[i]; };
  const auto mixed = [](double a1, double a2, double b1, double b2) { return 0.5 * (a1 * b2 + b1 * a2); };
  return c(0) * (a.x * b.x) + c(1) * mixed(a.x, a.y, b.x, b.y) + c(2) * mixed(a.x, a.z, b.x, b.z) +
         c(3) * mixed(a.x, a.w, b.x, b.w) + c(4) * (a.y * b.y) + c(5) * mixed(a.y, a.z, b.y, b.z) +
         c(6) * mixed(a.y, a.w, b.y, b.w) + c(7) * (a.z * b.z) + c(8) * mixed(a.z, a.w, b.z, b.w) + c(9) * (a.w * b.w);
}

/// The Bernstein coefficients of a quadratic form on a segment are its values and polar value at the ends.
FixedBernstein<2> quadric_along(const PreparedPolynomial& polynomial, const Piece& piece) {
  const HomogeneousPoint a{piece.x.l0, piece.y.l0, piece.z.l0, piece.w.l0},
      b{piece.x.l1, piece.y.l1, piece.z.l1, piece.w.l1};
  const std::vector<double>& c = polynomial.coefficients;
  return {{polar<false>(c, a, a), polar<false>(c, a, b), polar<false>(c, b, b)}};
}

/// P̂ along a piece.
Bernstein along(const PreparedPolynomial& polynomial, const Piece& piece) {
  const int n = polynomial.order;
  Scaled powers_of_w[kMostDegree + 1];
  powers_of_w[0].degree = 0;
  powers_of_w[0].c[0] = 1;
  for (int k = 1; k <= n; ++k) {
    powers_of_w[k].add_times(1, powers_of_w[k - 1]);
    powers_of_w[k].multiply(piece.w);
  }
  const double* coefficient = polynomial.coefficients.data();
  Scaled in_x;
  for (int i = 0; i <= n; ++i) {
    Scaled in_y;
    for (int j = 0; j <= i; ++j) {
      Scaled in_z;
      for (int k = 0; k <= j; ++k) {
        in_z.multiply(piece.z);
        in_z.add_times(*coefficient++, powers_of_w[k]);
      }
      in_y.multiply(piece.y);
      in_y.add_times(1, in_z);
    }
    in_x.multiply(piece.x);
    in_x.add_times(1, in_y);
  }
  Bernstein result;
  result.degree = n;
  for (int i = 0; i <= n; ++i) {
    result[i] = in_x.is_zero() ? 0 : in_x.c[static_cast<std::size_t>(i)] / binomial(n, i);
  }
  return result;
}

/// Horner's rule once more, with a term's missing order made up for by powers of w.
double value(const PreparedPolynomial& polynomial, double x, double y, double z, double w, bool absolute) {
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0;
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0;
    for (int j = 0; j <= i; ++j) {
      double in_z = 0, power = 1;
      for (int k = 0; k <= j; ++k) {
        const double c = *coefficient++;
        in_z = in_z * z + (absolute ? std::abs(c) : c) * power;
        power *= w;
      }
      in_y = in_y * y + in_z;
    }
    in_x = in_x * x + in_y;
  }
  return in_x;
}

/// The largest that the terms can add up to on the piece.
double magnitude(const PreparedPolynomial& polynomial, const Piece& piece) {
  if (polynomial.order == 2) {
    const HomogeneousPoint most{piece.x.largest(), piece.y.largest(), piece.z.largest(), piece.w.largest()};
    return polar<true>(polynomial.coefficients, most, most);
  }
  return value(polynomial, piece.x.largest(), piece.y.largest(), piece.z.largest(), piece.w.largest(), true);
}

/// Follows one polynomial along one line, from t = 0 on.
class PolynomialLine {
 public:
  PolynomialLine(const PreparedPolynomial& polynomial, const Vec3& origin, const Vec3& direction,
                 bool starts_on_surface)
      : polynomial_(polynomial), origin_(origin), direction_(direction), deflates_(starts_on_surface) {
    const double length = direction.length();
    foot_ = -origin.dot(direction) / direction.dot(direction);
    const Vec3 foot = origin + direction * foot_;
    h_ = std::max(foot.length(), polynomial.reach);
    if (!(h_ > 0)) h_ = origin.length() > 0 ? origin.length() : 1;  // a cone met at its apex: any length is as good
    near_ = h_ / length;
  }

  /// Follows the stretch alone if it can, else the whole line.
  Crossings follow(const Stretch& stretch) {
    if (follow_through(stretch)) return std::move(result_);
    if (std::isfinite(polynomial_.cube)) {
      follow_through_cube();
      return std::move(result_);
    }
    // t = foot − near/v up to foot − near, then to foot + near, then foot + near/v.
    const double from = std::max(0.0, foot_ - near_), to = foot_ + near_;
    if (from > 0) follow_far(-1, near_ / foot_, 1, true);
    if (to > 0) {
      const Vec3 a = point(from) / h_, b = point(to) / h_;
      follow({{a.x, b.x}, {a.y, b.y}, {a.z, b.z}, {1 / h_, 1 / h_}}, [&](double u) { return from + u * (to - from); });
      follow_far(1, 1, 0, false);
    } else {
      follow_far(1, -near_ / foot_, 0, true);
    }
    result_.ends_inside = sign_.sign() < 0;
    return std::move(result_);
  }

 private:
  [[nodiscard]] Vec3 point(double t) const { return origin_ + direction_ * t; }

  template <class Use>
  auto with_polynomial_along(const Piece& piece, const Use& use) const {
    switch (polynomial_.order) {
      case 2: return use(quadric_along(polynomial_, piece));
      case 3: return use(along<3>(polynomial_, piece));
      case 4: return use(along<4>(polynomial_, piece));
      default: return use(along(polynomial_, piece));
    }
  }
  [[nodiscard]] double band_of(const Piece& piece) const {
    return rounding_of_order(polynomial_.order) * magnitude(polynomial_, piece);
  }

  /// False if the stretch is too long, or its ends are too close to the surface.
  bool follow_through(const Stretch& stretch) {
    /// How much larger than on the usual pieces coordinates may be: n bits of 2ⁿ are lost.
    constexpr double kMostGrowth = 2;
    if (std::isinf(stretch.to) || !(stretch.from < stretch.to) || (deflates_ && stretch.from > 0)) return false;
    const Vec3 a = point(stretch.from), b = point(stretch.to);
    const double size = std::max({a.length(), b.length(), polynomial_.reach});
    if (!(size > 0 && size <= kMostGrowth * h_)) return false;
    const Piece piece{
        {a.x / size, b.x / size}, {a.y / size, b.y / size}, {a.z / size, b.z / size}, {1 / size, 1 / size}};
    return with_polynomial_along(piece, [&](const auto& p) {
      const double band = band_of(piece);
      if (stretch.from > 0 && !(std::abs(p[0]) > band)) return false;
      if (!(std::abs(p[p.degree]) > band * p.degree)) return false;  // certain, whether divided or not
      follow(p, band, [&](double u) { return stretch.from + u * (stretch.to - stretch.from); });
      result_.ends_inside = sign_.sign() < 0;
      return true;
    });
  }

  /// Follows the only piece of a bounded solid.
  void follow_through_cube() {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const double a = (-polynomial_.cube - origin_[i]) / direction_[i],
                   b = (polynomial_.cube - origin_[i]) / direction_[i];
      if (direction_[i] == 0 && !(std::abs(origin_[i]) <= polynomial_.cube)) return;
      if (direction_[i] == 0) continue;
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    if (!(from < to)) return;
    h_ = polynomial_.cube;
    if (from > 0) sign_ = SignFollower(1);
    const Vec3 a = point(from) / h_, b = point(to) / h_;
    follow({{a.x, b.x}, {a.y, b.y}, {a.z, b.z}, {1 / h_, 1 / h_}}, [&](double u) { return from + u * (to - from); });
  }

  /// t = foot + side·near/v for v from `from` to `to`. v·p(t)/h = v·foot/h + side·near/h·direction. `is_first`: the
  /// first v is t = 0.
  void follow_far(double side, double from, double to, bool is_first) {
    const Vec3 foot = point(foot_) / h_, step = direction_ * (side * near_ / h_);
    Vec3 a = foot * from + step;
    const Vec3 b = foot * to + step;
    if (is_first) a = origin_ * (from / h_);
    follow({{a.x, b.x}, {a.y, b.y}, {a.z, b.z}, {from / h_, to / h_}},
           [&](double u) { return foot_ + side * near_ / (from + u * (to - from)); });
  }

  template <class TimeAt>
  void follow(const Piece& piece, const TimeAt& time_at) {
    with_polynomial_along(piece, [&](const auto& p) { follow(p, band_of(piece), time_at); });
  }

  template <class Polynomial, class TimeAt>
  void follow(const Polynomial& p, double band, const TimeAt& time_at) {
    const auto add = [&](double u) { result_.add(time_at(u), kSide); };
    if (!deflates_) return sign_.follow(p, band, add);
    deflates_ = false;
    sign_.follow(over_u(p), band * p.degree, add);
  }

  const PreparedPolynomial& polynomial_;
  Vec3 origin_, direction_;
  bool deflates_;  ///< the next piece begins with the known root
  double foot_, h_, near_;
  SignFollower sign_{0};
  Crossings result_;
};

}  // namespace

PreparedPolynomial prepare(const scene::Polynomial& polynomial) {
  // The largest coefficients by total order; the position of a coefficient gives its powers.
  const int n = polynomial.order;
  std::array<double, kMostDegree + 1> largest{};
  std::size_t place = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (int k = 0; k <= j; ++k) {
        double& own = largest[static_cast<std::size_t>(n - k)];  // x^(n−i) y^(i−j) z^(j−k)
        own = std::max(own, std::abs(polynomial.coefficients[place++]));
      }
    }
  }
  PreparedPolynomial result;
  result.order = n;
  while (result.order > 0 && largest[static_cast<std::size_t>(result.order)] == 0) --result.order;
  place = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (int k = 0; k <= j; ++k, ++place) {
        // The remaining coefficients have the same nesting: i, j and k all fall by the number of orders that are
        // removed.
        if (k >= n - result.order) result.coefficients.push_back(polynomial.coefficients[place]);
      }
    }
  }
  const double leading = largest[static_cast<std::size_t>(result.order)];
  for (int k = 0; k < result.order; ++k) {
    const double share = largest[static_cast<std::size_t>(k)] / leading;
    if (share > 0) result.reach = std::max(result.reach, power(share, 1.0 / (result.order - k)));
  }
  // The nearest power of two, so that a scene scaled by one has the same digits.
  if (result.reach > 0 && std::isfinite(result.reach))
    result.reach = std::ldexp(1.0, std::ilogb(result.reach * std::sqrt(2.0)));
  result.cube = cube_of(result);
  return result;
}

Crossings polynomial_crossings(const PreparedPolynomial& polynomial, const Vec3& origin, const Vec3& direction,
                               std::uint8_t start_part, const Stretch& stretch) noexcept {
  if (polynomial.order == 0) {
    Crossings result;
    result.ends_inside = polynomial.coefficients[0] <= 0;
    return result;
  }
  if (polynomial.order == 2) {
    std::optional<Crossings> plain = plain_quadric_crossings(polynomial, origin, direction, start_part == kSide);
    if (plain) return std::move(*plain);
  }
  return PolynomialLine(polynomial, origin, direction, start_part == kSide).follow(stretch);
}

/// The gradient, by the product rule along Horner's.
Vec3 polynomial_normal(const PreparedPolynomial& polynomial, const Vec3& point) noexcept {
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0;
  Vec3 slope_x(0);
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0;
    Vec3 slope_y(0);
    for (int j = 0; j <= i; ++j) {
      double in_z = 0, slope_z = 0;
      for (int k = 0; k <= j; ++k) {
        slope_z = slope_z * point.z + in_z;
        in_z = in_z * point.z + *coefficient++;
      }
      slope_y = slope_y * point.y + Vec3(0, in_y, slope_z);
      in_y = in_y * point.y + in_z;
    }
    slope_x = slope_x * point.x + Vec3(in_x, slope_y.y, slope_y.z);
    in_x = in_x * point.x + in_y;
  }
  const double length = slope_x.length();
  return length > 0 && std::isfinite(length) ? slope_x / length : Vec3(0);
}

}  // namespace isl::render
