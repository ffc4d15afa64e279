// The own space of a pattern: points are taken into it by warps and turbulence, normals by the transforms among the
// warps alone, as in POV-Ray.
#pragma once

#include "renderer/patterns/warp_point.h"
#include "renderer/scene/database.h"
#include "renderer/values/function_machine.h"

#include <variant>

namespace isl::render {

/// own_point() for any pattern.
[[nodiscard]] scene::Vec3 own_point_of_any(const scene::Database& database, const scene::Pattern& pattern,
                                           const scene::Vec3& point, const values::Environment& environment) noexcept;

/// The point in the pattern's own space.
[[nodiscard]] inline scene::Vec3 own_point(const scene::Database& database, const scene::Pattern& pattern,
                                           const scene::Vec3& point, const values::Environment& environment) noexcept {
  // Most patterns are moved by transforms alone.
  if (pattern.uv_mapping || pattern.turbulence.amount != scene::Vec3(0))
    return own_point_of_any(database, pattern, point, environment);
  scene::Vec3 own = point;
  for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp) {
    const auto* const id = std::get_if<scene::TransformId>(&*warp);
    if (id == nullptr) return own_point_of_any(database, pattern, point, environment);
    own = database.transforms[index(*id)].inverse_point(own);
  }
  return within_limit(own);
}

/// Normals keep what the transforms do to their lengths.
[[nodiscard]] inline scene::Vec3 into_own_space(const scene::Database& database, const scene::Pattern& pattern,
                                                scene::Vec3 normal) noexcept {
  for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp) {
    if (const auto* const id = std::get_if<scene::TransformId>(&*warp))
      normal = database.transforms[index(*id)].inverse_normal(normal);
  }
  return normal;
}
[[nodiscard]] inline scene::Vec3 out_of_own_space(const scene::Database& database, const scene::Pattern& pattern,
                                                  scene::Vec3 normal) noexcept {
  for (const scene::Warp& warp : pattern.warps) {
    if (const auto* const id = std::get_if<scene::TransformId>(&warp))
      normal = database.transforms[index(*id)].normal(normal);
  }
  return normal;
}

}  // namespace isl::render
