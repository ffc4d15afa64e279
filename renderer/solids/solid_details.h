// The details of solids, prepared for rays: data that does not fit into one record, in the columns that
// scene::Solid::detail indexes.
#pragma once

#include "renderer/scene/solids.h"
#include "renderer/solids/outline_map.h"

#include <ImathBox.h>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace isl::scene {
struct Database;
}

namespace isl::render {

using scene::PlanePoint;
using scene::Vec3;

/// A polynomial of its true order (leading orders with only zero coefficients are removed), with its length scale.
struct PreparedPolynomial {
  int order = 0;
  std::vector<double> coefficients;  ///< in the order of scene::Polynomial
  /// The largest radius at which the terms of a lower order can be as large as those of the highest: max
  /// (A_k/A_n)^(1/(n−k)), with A_k the largest coefficient of order k, to the nearest power of two. Scales as the shape
  /// does; 0 for a cone.
  double reach = 0;
  /// Half the side of a cube about the origin that contains the inside; may be infinite.
  double cube = std::numeric_limits<double>::infinity();
};

/// A polygon projected along the axis nearest to its normal. The coordinates are those of the points, unchanged, so
/// that neighbours with a common edge have the same edge here.
struct PreparedPolygon {
  Vec3 normal{0};  ///< unit length
  Vec3 anchor{0};  ///< a point of the plane
  Imath::Box3d box;
  int axis_u = 0, axis_v = 1;
  std::vector<PlanePoint> starts, ends;  ///< one of each per edge
};

/// A part of a contour in a tree of boxes. A node with an order is a curve; the nodes of a longer part follow it.
struct OutlineNode {
  PlanePoint low, high;     ///< the box of the control points
  std::uint32_t next = 0;   ///< the node after all that belong to this one
  std::uint32_t first = 0;  ///< a curve's first control point
  int order = 0;
};

struct PreparedOutline {
  scene::Outline outline;
  std::vector<OutlineNode> nodes;  ///< contour after contour, each in the order of its curves
  OutlineMap map;
};

[[nodiscard]] PreparedPolynomial prepare(const scene::Polynomial& polynomial);
[[nodiscard]] PreparedPolygon prepare(const scene::Polygon& polygon);
[[nodiscard]] PreparedOutline prepare(const scene::Outline& outline);
/// Any other detail is used unchanged.
template <class Detail>
[[nodiscard]] const Detail& prepare(const Detail& detail) {
  return detail;
}

/// The details of all solids of one kind, as tracing reads them.
template <class Detail>
using PreparedColumn = std::vector<std::remove_cvref_t<decltype(prepare(std::declval<const Detail&>()))>>;

struct SolidDetails {
#define ISL_SOLID_DETAIL(word, Type, column) PreparedColumn<scene::Type> column;
#include "renderer/scene/solids.def"
};

/// For solids without details.
inline const SolidDetails kNoDetails;

[[nodiscard]] SolidDetails prepare_details(const scene::Database& database);

}  // namespace isl::render
