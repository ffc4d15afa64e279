// A check of hits: the field where a blob's surface was found is evaluated once more for shading, by code that shares
// nothing with the solver but the kernels, and so it tells at almost no cost whether the solver was wrong.
#pragma once

#include "renderer/compiled/compiled_scene.h"
#include "renderer/rays/blob_fields.h"
#include "renderer/rays/ray_steps.h"

#include <cstdint>

namespace isl::render {

/// A place where a solver found the blob's surface, in the blob's space.
struct FoundPlace {
  Vec3 point;
  Vec3 step;  ///< along the ray: how far the surface may be, by the tolerance and by rounding
  std::uint32_t cell;
};

/// True if it is certain that no surface lies between place.point ± place.step. The proof takes `steps` at most.
[[nodiscard]] bool is_refuted(const CompiledBlob& blob, const FoundPlace& place, const BlobFields& found,
                              RaySteps steps);

}  // namespace isl::render
