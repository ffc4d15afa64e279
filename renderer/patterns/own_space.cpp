#include "renderer/patterns/own_space.h"

#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/warp_point.h"

#include <variant>

namespace isl::render {

scene::Vec3 own_point(const scene::Database& database, const scene::Pattern& pattern, const scene::Vec3& point,
                      const values::Environment& environment) noexcept {
  const bool is_on_surface = pattern.uv_mapping && environment.coordinates() != nullptr;
  return warped(database, pattern, is_on_surface ? *environment.coordinates() : point,
                info_of(pattern.kind).uses_turbulence_itself ? PointTurbulence::no : PointTurbulence::yes);
}

scene::Vec3 into_own_space(const scene::Database& database, const scene::Pattern& pattern,
                           scene::Vec3 normal) noexcept {
  for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp) {
    if (const auto* const id = std::get_if<scene::TransformId>(&*warp))
      normal = database.transforms[index(*id)].inverse_normal(normal);
  }
  return normal;
}

scene::Vec3 out_of_own_space(const scene::Database& database, const scene::Pattern& pattern,
                             scene::Vec3 normal) noexcept {
  for (const scene::Warp& warp : pattern.warps) {
    if (const auto* const id = std::get_if<scene::TransformId>(&warp))
      normal = database.transforms[index(*id)].normal(normal);
  }
  return normal;
}

}  // namespace isl::render
