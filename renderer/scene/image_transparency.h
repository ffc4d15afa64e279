// Tells before an image is decoded whether it may let light through, so that scenes whose images cannot do not pay for
// transparency.
#pragma once

#include "renderer/scene/image.h"

namespace isl::scene {

/// False if no texel of an image_map, nor the space around it, lets light through.
[[nodiscard]] bool may_be_transparent(const Image& image);

}  // namespace isl::scene
