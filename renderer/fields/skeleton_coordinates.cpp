#include "renderer/fields/skeleton_coordinates.h"

#include "renderer/fields/record_skeleton.h"

namespace isl::render {

Coordinates skeleton_coordinates(const scene::Database& database, const scene::Blob& blob, std::uint32_t component,
                                 const Vec3& point, const Vec3& world) {
  const scene::Component& c = blob.components[component];
  if (database.kernels[scene::index(c.kernel)].meaning == scene::RadiusMeaning::support) return {world.x, world.y};
  const bool is_moved = c.transform != scene::kIdentity;
  const Vec3 p = is_moved ? database.transforms[scene::index(c.transform)].inverse_point(point) : point;
  const scene::Turn turn = blob.turns.empty() ? scene::Turn() : blob.turns[component];
  return with_skeleton_of(blob, c, [&](const auto& skeleton) { return skeleton.coordinates(p, turn); });
}

}  // namespace isl::render
