// Makes the skeleton of a component's record.
#pragma once

#include "renderer/fields/skeletons/skeletons.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isl::render {

/// True for a limb whose ends are the same point, or so close that the quotients of their coordinates, which are its
/// direction, lose digits below the least normal number, 2⁻¹⁰²²: below 2⁻⁹⁷⁰ they have fewer than 53. Precondition:
/// the skeleton has kEndB.
[[nodiscard]] inline bool has_no_length(const scene::Component& c) {
  const Vec3 along = c.b - c.a;
  return std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)}) < 0x1p-970;
}

/// True for a limb whose field is that of its thicker end, to rounding. Let the radius fall by κ a unit of length from
/// the thick end's R, with κ ≥ 2²⁷. The sphere at s from that end is farther in the measure of q than the thick one
/// for every point at D ≥ R/κ from it, since (D − s)/(R − κs) ≥ D/R. For all other points both q are below κ⁻² ≤ 2⁻⁵⁴,
/// so that they differ by less than the rounding of 1, the q of the surface.
[[nodiscard]] inline bool is_within_thick_end(const scene::Component& c) {
  const double step = c.radius_b - c.radius_a;
  return has(c.skeleton, scene::kRadiusB) && (c.b - c.a).length2() <= 0x1p-54 * (step * step);
}

/// The component in normal form: a limb that is no longer than a point becomes one, and members that the skeleton does
/// not use (b, radius_b) are copies of a and radius_a.
[[nodiscard]] inline scene::Component simplified(scene::Component c) {
  unsigned parts = scene::kSkeletonRecords[static_cast<std::size_t>(c.skeleton)];
  if ((parts & scene::kEndB) != 0 && (has_no_length(c) || is_within_thick_end(c))) {
    if ((parts & scene::kRadiusB) != 0 && c.radius_b > c.radius_a) {
      c.a = c.b;
      c.radius_a = c.radius_b;
    }
    c.skeleton = scene::Skeleton::point;
    parts = 0;
  }
  if ((parts & (scene::kPointB | scene::kEndB | scene::kDirectionB)) == 0) c.b = c.a;
  if ((parts & scene::kRadiusB) == 0) c.radius_b = c.radius_a;
  return c;
}

/// Calls `use` with the skeleton of a record, in the component's own space, and returns its result.
template <class Use>
auto with_skeleton_of(const scene::Blob& blob, const scene::Component& component, const Use& use) {
  const scene::Component c = simplified(component);
  return with_skeleton_type(c.skeleton, [&](auto type) { return use(typename decltype(type)::type(blob, c)); });
}

}  // namespace isl::render
