// Whether a point lies inside an object: by the definition of each shape, not by rays, so it holds for everything that
// the language can place.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <vector>

namespace isl::render {

/// In the solid's own space. Of the surface itself, as in POV-Ray: it is outside a sphere, cylinder, cone or disc and
/// inside everything else. Triangles and polygons have no inside; that of a disc is the half-space behind it.
[[nodiscard]] bool is_inside(const scene::Database& database, const scene::Solid& solid, const scene::Vec3& point);

/// In the blob's own space: the field reaches the threshold. `kernels` are those of the database.
[[nodiscard]] bool is_inside(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                             const scene::Blob& blob, const scene::Vec3& point);

/// `point` is in the space that the object is placed into. A clip also removes the inside that it cuts off. Sheets
/// (solids/solid.h) hold nothing, inverse or not, as in POV-Ray: of a solid minus a triangle nothing is left but the
/// triangle.
[[nodiscard]] bool is_inside(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                             const scene::Object& object, const scene::Vec3& point);

}  // namespace isl::render
