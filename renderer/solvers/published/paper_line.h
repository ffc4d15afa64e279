// One component as a ray sees it, for the published solver: the kernel's argument v and its slope at any t, in the
// component's own space. Geometry only: no kernel is evaluated here, except for a convolved curve, which has no
// argument.
#pragma once

#include "renderer/fields/component_table.h"
#include "renderer/fields/convolutions/curve_field.h"

namespace isl::render {

/// v and dv/dt along the ray.
struct KernelArgument {
  double v, slope;
};

struct FieldLine {
  const ComponentTable& table;
  const FieldGroup& group;
  std::uint32_t item;
  Vec3 origin, direction;

  /// `origin_` and `direction_` are in the blob's space.
  FieldLine(const ComponentTable& table_, std::uint32_t item_, const Vec3& origin_, const Vec3& direction_)
      : table(table_), group(table_.group_of(item_)), item(item_), origin(origin_), direction(direction_) {
    if (!group.is_mapped) return;
    const scene::Transform& map = table.blob_from_component(group, item);
    origin = map.inverse_point(origin);
    direction = map.inverse_vector(direction);
  }

  [[nodiscard]] KernelArgument at(double t) const {
    const Vec3 p = origin + direction * t;
    const Foot foot = table.with_skeleton(group, item, [&](const auto& skeleton) { return skeleton.nearest(p); });
    const Vec3 half_gradient = foot.offset * (ComponentTable::v_scale(group) * foot.inverse_radius2);
    return {half_gradient.dot(foot.offset), 2 * half_gradient.dot(direction)};
  }
  /// The value and gradient of a convolved curve.
  [[nodiscard]] CurveSample sample(double t) const {
    const Vec3 p = origin + direction * t;
    return table.with_skeleton(group, item,
                               [&](const auto& skeleton) { return curve_sample(group.kernel, skeleton, p); });
  }
};

}  // namespace isl::render
