// Plain solids, each in the space in which the scene describes it. What does not fit into one record lies in a column
// of its own kind, which Solid::detail indexes.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isl::scene {

/// sphere: centre a, radius_a. cylinder: a to b, radius_a, with flat caps. cone: a, radius_a to b, radius_b, flat caps.
/// plane: the half-space p·a ≤ radius_a, a normalised. box: least corner a, greatest corner b. torus: about the y axis,
/// radius_a from the origin to the circle, radius_b about the circle. disc: centre a, normal b (normalised), flat from
/// radius_b (0: no hole) to radius_a. quadric, cubic, quartic, poly: detail is a Polynomial of order 2, 3, 4, any.
/// superellipsoid: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) ≤ 1 with e = radius_a, n = radius_b. triangle,
/// smooth_triangle: detail is a Triangle. polygon: detail is a Polygon.
enum class SolidKind : std::uint8_t {
  sphere,
  cylinder,
  cone,
  plane,
  box,
  torus,
  disc,
  quadric,
  cubic,
  quartic,
  poly,
  superellipsoid,
  triangle,
  smooth_triangle,
  polygon,
};
inline constexpr int kSolidKindCount = static_cast<int>(SolidKind::polygon) + 1;

[[nodiscard]] constexpr bool is_polynomial(SolidKind kind) {
  return kind >= SolidKind::quadric && kind <= SolidKind::poly;
}
[[nodiscard]] constexpr bool is_triangle(SolidKind kind) {
  return kind == SolidKind::triangle || kind == SolidKind::smooth_triangle;
}

struct Solid {
  SolidKind kind = SolidKind::sphere;
  bool open = false;  ///< cylinder and cone: without caps
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
  std::uint32_t detail = kNone;  ///< index into the column of the kind
};

/// The set where the polynomial is ≤ 0. Terms in POV-Ray's order of `poly`: powers of x falling, within them powers of
/// y, within them powers of z; x², xy, xz, x, y², yz, y, z², z, 1 for order 2.
struct Polynomial {
  int order = 2;
  std::vector<double> coefficients;  ///< (order + 1)(order + 2)(order + 3)/6

  [[nodiscard]] static constexpr std::size_t coefficient_count(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
  }
};

/// Never degenerate.
struct Triangle {
  std::array<Vec3, 3> corners;
  std::array<Vec3, 3> normals;  ///< of a smooth_triangle, unit length; else all the same, across the triangle
};

/// A flat area between closed contours; where contours overlap, what an even number of them holds is a hole.
struct Polygon {
  std::vector<Vec3> points;  ///< contour after contour, each ending with its first point; all in one plane
};

}  // namespace isl::scene
