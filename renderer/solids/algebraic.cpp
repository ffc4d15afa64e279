// quadric, cubic, quartic, poly: the sets where a polynomial is ≤ 0 (polynomial.cpp has their crossings), with their
// bounds.
//
// An ellipsoid is {p: pᵀAp + b·p + c ≤ 0} with A positive definite: its centre is m = −A⁻¹b/2, and with k = mᵀAm − c it
// is (p − m)ᵀA(p − m) ≤ k, which reaches d·m + √(k dᵀA⁻¹d).
#include "renderer/solids/polynomial.h"
#include "renderer/solids/solid_type.h"

#include <vector>

namespace isl::render {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

template <Wanted wanted>
Crossings algebraic_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                              std::uint32_t start_part, const SolidDetails& details) noexcept {
  return polynomial_crossings(details.polynomials[solid.detail], origin, direction, start_part, wanted);
}

Crossings algebraic_boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint32_t start_part, const SolidDetails& details, const Stretch& stretch) noexcept {
  return polynomial_crossings(details.polynomials[solid.detail], origin, direction, start_part, Wanted::all, stretch);
}

Vec3 algebraic_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point,
                      const SolidDetails& details) noexcept {
  return polynomial_normal(details.polynomials[solid.detail], point);
}

double terms_of_algebraic(const scene::Solid& solid, const Vec3& point, const SolidDetails& details) noexcept {
  return terms_over_gradient(details.polynomials[solid.detail], point);
}

/// The greatest direction · p over the points with pᵀAp + b·p + c ≤ 0; infinite for any other quadric than an
/// ellipsoid. The coefficients are in the order of scene::Polynomial.
double ellipsoid_reach(const std::vector<double>& q, const Vec3& direction) {
  // Terms: x², xy, xz, x, y², yz, y, z², z, 1. Columns of the symmetric A:
  const Vec3 a0(q[0], q[1] / 2, q[2] / 2), a1(q[1] / 2, q[4], q[5] / 2), a2(q[2] / 2, q[5] / 2, q[7]);
  const Vec3 c0 = a1.cross(a2), c1 = a2.cross(a0), c2 = a0.cross(a1);
  const double determinant = a0.dot(c0);
  const bool is_definite = a0.x > 0 && a0.x * a1.y - a0.y * a0.y > 0 && determinant > 0;
  if (!is_definite) return kFar;
  const auto solved = [&](const Vec3& v) { return Vec3(c0.dot(v), c1.dot(v), c2.dot(v)) / determinant; };
  const Vec3 b(q[3], q[6], q[8]);
  const Vec3 centre = solved(b) * -0.5;
  const double k = -centre.dot(b) / 2 - q[9];  // Am = −b/2
  return direction.dot(centre) + std::sqrt(std::max(k, 0.0) * direction.dot(solved(direction)));
}

Box algebraic_bounds(const scene::Solid& solid, const SolidDetails& details) noexcept {
  const PreparedPolynomial& polynomial = details.polynomials[solid.detail];
  if (polynomial.order != 2) return {Vec3(-polynomial.cube), Vec3(polynomial.cube)};
  Box box;
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    // The margin covers the rounding of some 30 operations, whose terms are of the size of the result and the centre.
    const double high = ellipsoid_reach(polynomial.coefficients, axis),
                 low = -ellipsoid_reach(polynomial.coefficients, -axis);
    const double margin = 0x1p-46 * (std::abs(high) + std::abs(low));
    box.min[i] = low - (std::isfinite(margin) ? margin : 0);
    box.max[i] = high + (std::isfinite(margin) ? margin : 0);
  }
  return box;
}

double quadric_support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction) {
  return ellipsoid_reach(database.polynomials[solid.detail].coefficients, direction);
}

double unknown_support(const scene::Database&, const scene::Solid&, const Vec3&) { return kFar; }

/// Evaluates by Horner's rule, as a polynomial in x whose coefficients are polynomials in y, whose coefficients are
/// polynomials in z.
bool is_in_algebraic(const scene::Database& database, const scene::Solid& solid, const Vec3& p) {
  const scene::Polynomial& polynomial = database.polynomials[solid.detail];
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0;
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0;
    for (int j = 0; j <= i; ++j) {
      double in_z = 0;
      for (int k = 0; k <= j; ++k) in_z = in_z * p.z + *coefficient++;
      in_y = in_y * p.y + in_z;
    }
    in_x = in_x * p.x + in_y;
  }
  return in_x <= 0;
}

double algebraic_size(const scene::Database& database, const scene::Solid& solid) {
  return prepare(database.polynomials[solid.detail]).reach;
}

constexpr SolidType with_support(double (*support)(const scene::Database&, const scene::Solid&, const Vec3&)) {
  return {.crossings = algebraic_crossings<Wanted::all>,
          .crossings_to_first = algebraic_crossings<Wanted::first>,
          .boundary_in_stretch = algebraic_boundary,
          .normal = algebraic_normal,
          .bounds = algebraic_bounds,
          .support = support,
          .is_inside = is_in_algebraic,
          .size = algebraic_size,
          .terms_over_gradient = terms_of_algebraic};
}

/// The crossings of nearly all lines with a quadric have a closed form, which no stretch makes shorter.
constexpr SolidType without_stretch(SolidType type) {
  type.boundary_in_stretch = nullptr;
  return type;
}

}  // namespace

constinit const SolidType kinds::quadric = without_stretch(with_support(quadric_support));
constinit const SolidType kinds::cubic = with_support(unknown_support);
constinit const SolidType kinds::quartic = with_support(unknown_support);
constinit const SolidType kinds::poly = with_support(unknown_support);

}  // namespace isl::render
