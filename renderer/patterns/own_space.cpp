#include "renderer/patterns/own_space.h"

#include "renderer/patterns/kinds/pattern_kind.h"

namespace isl::render {

scene::Vec3 own_point_of_any(const scene::Database& database, const scene::Pattern& pattern, const scene::Vec3& point,
                             const values::Environment& environment) noexcept {
  const bool is_on_surface = pattern.uv_mapping && environment.coordinates() != nullptr;
  return warped(database, pattern, is_on_surface ? *environment.coordinates() : point,
                info_of(pattern.kind).uses_turbulence_itself ? PointTurbulence::no : PointTurbulence::yes);
}

}  // namespace isl::render
