// Tells before an image is decoded, and a colour's functions are evaluated, whether they may let light through, so that
// scenes whose images and colours cannot do not pay for transparency.
#pragma once

#include "renderer/scene/image.h"
#include "renderer/scene/pattern.h"

namespace isl::scene {

/// False if no texel of an image_map, nor the space around it, lets light through.
[[nodiscard]] bool may_be_transparent(const Image& image);

/// False if the colour has neither `filter` nor `transmit`.
[[nodiscard]] inline bool may_be_transparent(const ColourOperands& colour) {
  return colour.terms[3] != kNoFunction || colour.terms[4] != kNoFunction;
}

}  // namespace isl::scene
