// Skeleton coordinates: where along a component's skeleton a point lies, and around it. For the few points where a
// texture asks for them; straight from the records.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solids/surface_coordinates.h"

#include <cstdint>

namespace isl::render {

/// Of component number `component` at a point of the blob's space. `world` is the same point in the world: POV-Ray's
/// own components (RadiusMeaning::support) have (x, y) of it, as all shapes that it knows no coordinates of.
[[nodiscard]] Coordinates skeleton_coordinates(const scene::Database& database, const scene::Blob& blob,
                                               std::uint32_t component, const Vec3& point, const Vec3& world);

}  // namespace isl::render
