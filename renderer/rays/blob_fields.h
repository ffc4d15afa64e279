// The sums of a blob's fields and of their gradients at a point.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

using scene::Vec3;

struct BlobFields {
  double value = 0;      ///< Σfᵢ
  double magnitude = 0;  ///< Σ|fᵢ|
  Vec3 gradient{0};      ///< ∇F, in the blob's space
};

}  // namespace isl::render
