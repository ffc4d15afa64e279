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
// On the middle piece P is a polynomial of s = (t − foot)/near, on the others of v. All have the same coefficients
// (line_polynomial.h), in opposite order, and what rounding moves these by is bounded once for the whole line. The
// pieces are followed in Bernstein form.
//
// If a cube that contains the inside is known (polynomial_bound.h), the line's part within it is the only piece.
//
// If only a stretch of the line is asked for, and is no longer than the pieces' sizes allow, it is the only piece. The
// polynomial's sign must be certain at both of its ends: a crossing that is not wholly inside would be lost otherwise.
// Both it and the part in a cube are followed about their middle.
//
// A ray that starts on the surface begins the first piece at its own origin, where the coefficient is 0: divided out.
#include "renderer/solids/polynomial.h"

#include "renderer/numerics/polynomial_roots.h"
#include "renderer/numerics/power.h"
#include "renderer/solids/line_polynomial.h"
#include "renderer/solids/polynomial_bound.h"
#include "renderer/solids/quadric_line.h"
#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isl::render {
namespace {

/// Leaves the part of [0, 1] from `from` on (de Casteljau).
template <class Polynomial>
void keep_from(Polynomial& p, double from) {
  if (from <= 0) return;
  for (int level = 1; level <= p.degree; ++level) {
    for (int i = 0; i <= p.degree - level; ++i) p[i] = p[i] * (1 - from) + p[i + 1] * from;
  }
}

template <class Polynomial>
void reverse(Polynomial& p) {
  for (int i = 0, j = p.degree; i < j; ++i, --j) std::swap(p[i], p[j]);
}

/// Follows one polynomial along one line, from t = 0 on.
class PolynomialLine {
 public:
  PolynomialLine(const PreparedPolynomial& polynomial, const Vec3& origin, const Vec3& direction,
                 bool starts_on_surface, Wanted wanted, Crossings& result)
      : polynomial_(polynomial),
        origin_(origin),
        direction_(direction),
        deflates_(starts_on_surface),
        result_(result),
        taker_(result, wanted) {
    const double length = direction.length();
    foot_ = -origin.dot(direction) / direction.dot(direction);
    const Vec3 foot = point(foot_);
    h_ = std::max(foot.length(), polynomial.reach);
    if (!(h_ > 0)) h_ = origin.length() > 0 ? origin.length() : 1;  // a cone met at its apex: any length is as good
    near_ = h_ / length;
  }

  /// Follows the stretch alone if it can, else the whole line.
  void follow(const Stretch& stretch) {
    wanted_to_ = stretch.wanted_to;
    switch (polynomial_.order) {
      case 2: follow_as<FixedBernstein<2>>(stretch); break;
      case 3: follow_as<FixedBernstein<3>>(stretch); break;
      case 4: follow_as<FixedBernstein<4>>(stretch); break;
      default: follow_as<Bernstein>(stretch);
    }
  }

 private:
  [[nodiscard]] Vec3 point(double t) const { return origin_ + direction_ * t; }

  template <class Polynomial>
  void follow_as(const Stretch& stretch) {
    if (follow_stretch<Polynomial>(stretch)) return;
    if (std::isfinite(polynomial_.cube)) return follow_through_cube<Polynomial>();
    follow_line<Polynomial>();
    result_.ends_inside = sign_.sign() < 0;
  }

  template <class Polynomial>
  void follow_line() {
    const LinePart part{point(foot_) / h_, direction_ * (near_ / h_), 1 / h_};
    const PowerForm<Polynomial> p(polynomial_, part);
    const double band = band_of(part);
    // The first piece begins at t = 0. The ends of the others are −1 and 1 in s.
    const double begin = -foot_ / near_;
    if (begin < -1) {
      const double first = -1 / begin;
      Polynomial before = p.from_infinity(-1);
      keep_from(before, first);
      follow(before, band, [&](double u) { return foot_ - near_ / (first + u * (1 - first)); });
      if (is_done_) return;
    }
    if (begin < 1) {
      Polynomial middle = p.on_part();
      keep_from(middle, 0.5 * (begin + 1));
      const double from = std::max(0.0, foot_ - near_), to = foot_ + near_;
      follow(middle, band, [&](double u) { return from + u * (to - from); });
      if (is_done_) return;
    }
    const double last = begin > 1 ? 1 / begin : 1;
    Polynomial beyond = p.from_infinity(1);
    reverse(beyond);
    keep_from(beyond, 1 - last);
    follow(beyond, band, [&](double u) { return foot_ + near_ / (last * (1 - u)); });
  }

  /// False if the stretch is too long, or its ends are too close to the surface.
  template <class Polynomial>
  bool follow_stretch(const Stretch& stretch) {
    if (std::isinf(stretch.to) || !(stretch.from < stretch.to) || (deflates_ && stretch.from > 0)) return false;
    const double size = std::max({point(stretch.from).length(), point(stretch.to).length(), polynomial_.reach});
    if (!(size > 0 && size <= kMostStretchGrowth * h_)) return false;
    double band = 0;
    const Polynomial p = between<Polynomial>(stretch.from, stretch.to, size, band);
    if (stretch.from > 0 && !(std::abs(p[0]) > band)) return false;
    if (!(std::abs(p[p.degree]) > band * p.degree)) return false;  // certain, whether divided or not
    follow_between(p, band, stretch.from, stretch.to);
    return true;
  }

  /// Follows the only piece of a bounded solid.
  template <class Polynomial>
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
    if (from > 0) sign_ = SignFollower(1);
    double band = 0;
    const Polynomial p = between<Polynomial>(from, to, polynomial_.cube, band);
    follow_between(p, band, from, to);
  }

  /// The polynomial from one t to another, and its band. Coordinates are at most `size`.
  template <class Polynomial>
  Polynomial between(double from, double to, double size, double& band) const {
    const Vec3 a = point(from) / size, b = point(to) / size;
    const LinePart part{(a + b) * 0.5, (b - a) * 0.5, 1 / size};
    band = band_of(part);
    return PowerForm<Polynomial>(polynomial_, part).on_part();
  }
  template <class Polynomial>
  void follow_between(const Polynomial& p, double band, double from, double to) {
    follow(p, band, [&](double u) { return from + u * (to - from); });
    result_.ends_inside = sign_.sign() < 0;
  }

  [[nodiscard]] double band_of(const LinePart& part) const {
    return rounding_on_line(polynomial_.order) * largest_terms(polynomial_, part);
  }

  template <class Polynomial, class TimeAt>
  void follow(const Polynomial& p, double band, const TimeAt& time_at) {
    if (!deflates_) return take_crossings(p, band, time_at);
    deflates_ = false;
    take_crossings(over_u(p), band * p.degree, time_at);
  }
  template <class Polynomial, class TimeAt>
  void take_crossings(const Polynomial& p, double band, const TimeAt& time_at) {
    // Beyond what is wanted only an unknown sign is looked for.
    if (sign_.sign() != 0 && time_at(0) >= wanted_to_) {
      is_done_ = true;
      return;
    }
    sign_.bracket(p, band, [&](double low, double high) {
      is_done_ = time_at(low) >= wanted_to_ || !taker_.add(time_at(sign_.root_between(p, low, high)));
      return !is_done_;
    });
  }

  const PreparedPolynomial& polynomial_;
  Vec3 origin_, direction_;
  bool deflates_;  ///< the next piece begins with the known root
  double foot_, h_, near_;
  double wanted_to_ = std::numeric_limits<double>::infinity();
  SignFollower sign_{0};
  Crossings& result_;
  CrossingsTaker taker_;
  bool is_done_ = false;  ///< no more crossings are wanted
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
                               std::uint32_t start_part, Wanted wanted, const Stretch& stretch) noexcept {
  Crossings result;
  if (polynomial.order == 0) {
    result.ends_inside = polynomial.coefficients[0] <= 0;
    return result;
  }
  const bool is_on_surface = start_part == kSide;
  if (polynomial.order == 2 && find_plain_crossings(polynomial, origin, direction, is_on_surface, result)) {
    return result;
  }
  PolynomialLine(polynomial, origin, direction, is_on_surface, wanted, result).follow(stretch);
  return result;
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
