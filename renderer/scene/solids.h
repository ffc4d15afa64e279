// Solids, each in the space in which the scene describes it. Data that does not fit into one record is in a column of
// the kind's own, which Solid::detail indexes. solids.def lists the solids and the columns.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace isl::scene {

enum class SolidKind : std::uint8_t {
#define ISL_SOLID(word, ...) word,
#include "renderer/scene/solids.def"
};

/// The column that Solid::detail indexes.
enum class SolidDetail : std::uint8_t {
  none,
#define ISL_SOLID_DETAIL(word, Type, column) word,
#include "renderer/scene/solids.def"
};

/// The properties of a kind of solid that the interpreter and dumps use.
struct SolidTraits {
  std::string_view word = {};
  /// The names of the record's members in a dump; "" if the kind does not use them.
  std::string_view a = {}, b = {}, radius_a = {}, radius_b = {};
  SolidDetail detail = SolidDetail::none;
  bool takes_sturm = false;  ///< `sturm` is allowed in its block, since POV-Ray solves polynomials for it
};

inline constexpr SolidTraits kSolidTraits[] = {
#define ISL_SOLID(kind, ...) {.word = #kind, __VA_ARGS__},
#include "renderer/scene/solids.def"
};

inline constexpr int kSolidKindCount = static_cast<int>(std::size(kSolidTraits));

[[nodiscard]] constexpr const SolidTraits& traits_of(SolidKind kind) {
  return kSolidTraits[static_cast<std::size_t>(kind)];
}
[[nodiscard]] constexpr bool is_polynomial(SolidKind kind) { return traits_of(kind).detail == SolidDetail::polynomial; }
[[nodiscard]] constexpr bool is_triangle(SolidKind kind) { return traits_of(kind).detail == SolidDetail::triangle; }

struct Solid {
  SolidKind kind = SolidKind::sphere;
  bool open = false;  ///< cylinder and cone: without caps
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
  std::uint32_t detail = kNone;  ///< index into the column of the kind
};

// ---- Details --------------------------------------------------------------------------------------------------------
// describe(kind, say) calls say(name, value) for every value that a dump prints.

/// The set where the polynomial is ≤ 0. Terms in POV-Ray's order of `poly`: powers of x falling, within them powers of
/// y, within them powers of z; x², xy, xz, x, y², yz, y, z², z, 1 for order 2.
struct Polynomial {
  int order = 2;
  std::vector<double> coefficients;  ///< (order + 1)(order + 2)(order + 3)/6

  [[nodiscard]] static constexpr std::size_t coefficient_count(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
  }
  template <class Say>
  void describe(SolidKind, const Say& say) const {
    say("order", order);
    say("coefficients", coefficients);
  }
};

/// A triangle; never degenerate.
struct Triangle {
  std::array<Vec3, 3> corners;
  std::array<Vec3, 3> normals;  ///< of a smooth_triangle, unit length; otherwise all are the triangle's own normal

  template <class Say>
  void describe(SolidKind kind, const Say& say) const {
    say("corners", corners);
    if (kind == SolidKind::smooth_triangle) say("normals", normals);
  }
};

/// A flat area bounded by closed contours. Points inside an even number of contours are outside (even-odd rule).
struct Polygon {
  std::vector<Vec3> points;  ///< contour after contour, each ending with its first point; all in one plane

  template <class Say>
  void describe(SolidKind, const Say& say) const {
    say("points", points);
  }
};

/// A point of a plane in a solid's own space.
struct PlanePoint {
  double u = 0, v = 0;
  bool operator==(const PlanePoint&) const = default;
};

/// A part of a plane between closed contours, each a chain of Bézier curves of the orders 1 to 3, that is swept along
/// the axis across the plane.
struct Outline {
  /// The control points of one contour after another. Neighbouring curves share a point, and the last point of a
  /// contour is its first, so that a contour has one point more than the sum of its orders.
  std::vector<PlanePoint> points;
  std::vector<std::uint8_t> orders;     ///< of each curve
  std::vector<std::uint32_t> contours;  ///< the number of curves of each contour; none is 0
  /// Inside is where contours wind around a point at all, as fonts define it; otherwise, where an odd number of
  /// contours surrounds it.
  bool fills_by_winding = false;
  bool is_conic = false;  ///< the section at height h is scaled by h, so that the sides meet at the origin

  template <class Say>
  void describe(SolidKind, const Say& say) const {
    say("orders", orders);
    say("contours", contours);
    say("points", points);
    if (is_conic) say("sweep", std::string_view("conic"));
  }
};

}  // namespace isl::scene
