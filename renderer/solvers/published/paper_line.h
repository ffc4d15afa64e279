// One component as a ray sees it, for the published solver: the kernel's argument v and its slope at any t, in the
// component's own space.
#pragma once

#include "renderer/fields/component_point.h"

namespace isl::render {

/// v and dv/dt along the ray.
struct ArgumentOnLine {
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

  [[nodiscard]] ArgumentOnLine at(double t) const {
    const KernelArgument here = argument_in_own_space(table, group, item, origin + direction * t);
    return {here.v, 2 * here.half_gradient.dot(direction)};
  }
  /// The value and gradient of a convolved curve.
  [[nodiscard]] CurveSample sample(double t) const {
    return curve_in_own_space(table, group, item, origin + direction * t);
  }
};

}  // namespace isl::render
