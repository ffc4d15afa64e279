// Dispatch by kind: the only place that lists the solids that rays can meet; scene/unrendered.h keeps all others away. A
// new one is a file, a line in kinds.h, a case in each switch, and a row less there.
#include "renderer/solids/solid.h"

#include "base/check.h"
#include "renderer/solids/kinds.h"

#include <limits>

namespace isl::render {

using scene::SolidKind;

Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                    std::uint8_t start_part) noexcept {
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_crossings(solid, origin, direction, start_part);
    case SolidKind::cylinder: return cylinder_crossings(solid, origin, direction, start_part);
    case SolidKind::cone: return cone_crossings(solid, origin, direction, start_part);
    case SolidKind::plane: return plane_crossings(solid, origin, direction, start_part);
    default: break;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

Vec3 normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point) noexcept {
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_normal(solid, point);
    case SolidKind::cylinder: return cylinder_normal(solid, part, point);
    case SolidKind::cone: return cone_normal(solid, part, point);
    case SolidKind::plane: return solid.a;
    default: break;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

Box bounds(const scene::Solid& solid) noexcept {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_bounds(solid);
    case SolidKind::cylinder: return capped_bounds(solid, solid.radius_a);
    case SolidKind::cone: return capped_bounds(solid, solid.radius_b);
    case SolidKind::plane: return {Vec3(-kFar), Vec3(kFar)};
    default: break;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

}  // namespace isl::render
