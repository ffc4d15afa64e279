// Skeleton coordinates: the position of a point along a component's skeleton and around it. They are computed from the
// records, since textures need them at few points.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solids/surface_coordinates.h"

#include <cstdint>

namespace isl::render {

/// The coordinates of a point of the blob's space on component number `component`. `world` is the same point in the
/// world: POV-Ray's own components (RadiusMeaning::support) have its (x, y) as coordinates, like all shapes for which
/// POV-Ray defines none.
[[nodiscard]] Coordinates skeleton_coordinates(const scene::Database& database, const scene::Blob& blob,
                                               std::uint32_t component, const Vec3& point, const Vec3& world);

}  // namespace isl::render
