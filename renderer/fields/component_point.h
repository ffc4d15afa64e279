// One component of a table at a point: the argument of its kernel, or the value of a convolved curve, with the
// gradient. Shading, the published solver and its normals are built on these. Kernels are not evaluated here, except
// for convolved curves, which have no argument.
#pragma once

#include "renderer/fields/component_table.h"
#include "renderer/fields/convolutions/curve_field.h"

namespace isl::render {

/// v and half of ∇v. With the nearest sphere's centre c and radius r, ∇v = 2 scale (p − c)/r² (the envelope theorem: c
/// is the nearest).
struct KernelArgument {
  double v;
  Vec3 half_gradient;
};

/// The argument and its gradient in the component's own space; so is `p`.
[[nodiscard]] inline KernelArgument argument_in_own_space(const ComponentTable& table, const FieldGroup& group,
                                                          std::uint32_t item, const Vec3& p) {
  const Foot foot = table.with_skeleton(group, item, [&](const auto& skeleton) { return skeleton.nearest(p); });
  const Vec3 half_gradient = foot.offset * (ComponentTable::v_scale(group) * foot.inverse_radius2);
  return {half_gradient.dot(foot.offset), half_gradient};
}
/// Value and gradient of a convolved curve in the component's own space, without its amplitude.
[[nodiscard]] inline CurveSample curve_in_own_space(const ComponentTable& table, const FieldGroup& group,
                                                    std::uint32_t item, const Vec3& p) {
  return table.with_skeleton(group, item,
                             [&](const auto& skeleton) { return curve_sample(group.kernel, skeleton, p); });
}

/// The same two functions in the blob's space.
[[nodiscard]] inline KernelArgument argument_at(const ComponentTable& table, const FieldGroup& group,
                                                std::uint32_t item, const Vec3& point) {
  if (!group.is_mapped) return argument_in_own_space(table, group, item, point);
  const scene::Transform& map = table.blob_from_component(group, item);
  const KernelArgument own = argument_in_own_space(table, group, item, map.inverse_point(point));
  return {own.v, map.normal(own.half_gradient)};
}
[[nodiscard]] inline CurveSample curve_at(const ComponentTable& table, const FieldGroup& group, std::uint32_t item,
                                          const Vec3& point) {
  if (!group.is_mapped) return curve_in_own_space(table, group, item, point);
  const scene::Transform& map = table.blob_from_component(group, item);
  const CurveSample own = curve_in_own_space(table, group, item, map.inverse_point(point));
  return {own.value, map.normal(own.gradient)};
}

}  // namespace isl::render
