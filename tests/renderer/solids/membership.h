// The flat solids and those with more than a quadratic, defined independently as signed functions in long double,
// without any solving; and random ones of about unit size.
#pragma once

#include "tests/renderer/solids/solid_oracle.h"

#include <cmath>
#include <vector>

namespace isl::render::test {

/// A solid with the records that it needs.
struct WholeSolid {
  scene::Solid solid;
  SolidDetails details{};
  scene::Polynomial polynomial{};  ///< for an algebraic solid
};

/// `absolute`: every term is taken as positive.
inline Real polynomial_value(const scene::Polynomial& polynomial, const RealVec& p, bool absolute = false) {
  std::array<std::array<Real, 36>, 3> powers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real base = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    powers[axis][0] = 1;
    for (std::size_t k = 1; k < 36; ++k) powers[axis][k] = powers[axis][k - 1] * (absolute ? std::abs(base) : base);
  }
  Real sum = 0;
  std::size_t place = 0;
  const auto n = static_cast<std::size_t>(polynomial.order);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        const Real c = polynomial.coefficients[place++];
        sum += (absolute ? std::abs(c) : c) * powers[0][n - i] * powers[1][i - j] * powers[2][j - k];
      }
    }
  }
  return sum;
}

/// Negative inside, zero on the surface. Near the surface it is about the distance, except for polynomials.
inline Real membership(const WholeSolid& whole, const RealVec& p) {
  const scene::Solid& solid = whole.solid;
  switch (solid.kind) {
    case scene::SolidKind::box:
      return std::max(
          {solid.a.x - p.x, p.x - solid.b.x, solid.a.y - p.y, p.y - solid.b.y, solid.a.z - p.z, p.z - solid.b.z});
    case scene::SolidKind::torus:
      return std::hypot(std::hypot(p.x, p.z) - static_cast<Real>(solid.radius_a), p.y) -
             static_cast<Real>(solid.radius_b);
    case scene::SolidKind::ovus: {
      const Real b = solid.radius_a, t = solid.radius_b;
      const Real d = solid.a.x > 0 ? static_cast<Real>(solid.a.x) : b;
      const Real c = solid.a.y > 0 ? static_cast<Real>(solid.a.y) : 2 * std::max(b, t);
      // The centre of the middle arc, (-h, v), is c - b away from (0, 0) and c - t away from (0, d).
      const Real v = ((c - b) * (c - b) - (c - t) * (c - t) + d * d) / (2 * d);
      const Real h = std::sqrt(std::max<Real>(0, (c - b) * (c - b) - v * v));
      const Real rho = std::hypot(p.x, p.z), x = rho + h, y = p.y - v;
      // Seen from there, what lies beyond the line through a sphere's centre is nearest to that sphere.
      if (h * y < -v * x) return std::hypot(rho, p.y) - b;
      if (h * y > (d - v) * x) return std::hypot(rho, p.y - d) - t;
      return std::hypot(x, y) - c;
    }
    case scene::SolidKind::superellipsoid: {
      const Real e = 2 / static_cast<Real>(solid.radius_a), n = 2 / static_cast<Real>(solid.radius_b);
      const Real ring = std::pow(std::pow(std::abs(p.x), e) + std::pow(std::abs(p.y), e), 1 / e);
      return std::pow(ring, n) + std::pow(std::abs(p.z), n) - 1;
    }
    default: return polynomial_value(whole.polynomial, p);
  }
}

inline WholeSolid algebraic(int order, std::vector<double> coefficients) {
  WholeSolid whole;
  whole.polynomial = {order, std::move(coefficients)};
  whole.solid.kind = scene::SolidKind::poly;
  whole.solid.detail = 0;
  whole.details.polynomials.push_back(prepare(whole.polynomial));
  return whole;
}

inline WholeSolid random_whole(Random& random, scene::SolidKind kind) {
  WholeSolid whole;
  whole.solid.kind = kind;
  switch (kind) {
    case scene::SolidKind::box: {
      const Vec3 p = random.in_cube(1), q = random.in_cube(1);
      for (int i = 0; i < 3; ++i) {
        whole.solid.a[i] = std::min(p[i], q[i]);
        whole.solid.b[i] = std::max(p[i], q[i]);
      }
      break;
    }
    case scene::SolidKind::torus:
      whole.solid.radius_a = random.uniform(0.3, 1);
      // Rings from thin to fat ones, and spindles.
      whole.solid.radius_b = whole.solid.radius_a * std::exp2(random.uniform(-8, 1.5));
      break;
    case scene::SolidKind::ovus: {
      whole.solid.radius_a = random.uniform(0.2, 0.6);
      // All the way from the sphere at the bottom to the sphere at the top, and nearly these.
      const double form = random.uniform(0, 6), little = std::exp2(random.uniform(-40, -1));
      const double ratio = form < 1 ? little : form < 2 ? 2 - little : random.uniform(0, 2);
      whole.solid.radius_b = whole.solid.radius_a * ratio;
      if (random.uniform(0, 1) < 0.5) {
        whole.solid.a.x = whole.solid.radius_a * random.uniform(1, 3);
        const double height = whole.solid.radius_a + whole.solid.radius_b + whole.solid.a.x;
        whole.solid.a.y = height * (0.5 + std::exp2(random.uniform(-20, 2)));
      }
      break;
    }
    case scene::SolidKind::superellipsoid:
      whole.solid.radius_a = std::exp2(random.uniform(-5, 2.5));
      whole.solid.radius_b = std::exp2(random.uniform(-5, 2.5));
      break;
    default: {
      const int order = kind == scene::SolidKind::quadric   ? 2
                        : kind == scene::SolidKind::cubic   ? 3
                        : kind == scene::SolidKind::quartic ? 4
                                                            : 2 + static_cast<int>(random.uniform(0, 9));
      std::vector<double> coefficients(scene::Polynomial::coefficient_count(order));
      const bool is_sparse = random.uniform(0, 1) < 0.5;
      for (double& c : coefficients) {
        c = is_sparse && random.uniform(0, 1) < 0.7 ? 0 : random.uniform(-1, 1);
      }
      coefficients[0] += 0.5;
      whole = algebraic(order, coefficients);
      whole.solid.kind = kind;
      break;
    }
  }
  return whole;
}

inline constexpr scene::SolidKind kWholeKinds[] = {
    scene::SolidKind::box,     scene::SolidKind::torus, scene::SolidKind::superellipsoid, scene::SolidKind::ovus,
    scene::SolidKind::quadric, scene::SolidKind::cubic, scene::SolidKind::quartic,        scene::SolidKind::poly};

}  // namespace isl::render::test
