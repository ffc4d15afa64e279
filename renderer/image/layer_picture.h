// Layers as pictures that any viewer shows: in false colours, with a legend below.
#pragma once

#include "renderer/image/false_colour.h"
#include "renderer/image/image.h"

namespace isl::render {

/// The scale of errors in pixels, the same wherever they are shown. An error below a ten-thousandth has no effect; one
/// above a hundred belongs to another surface.
inline constexpr ColourScale kErrorScale{1e-4, 1e2, true};

/// The scale of counts up to `most`: from 1 to the next power of two, at least 2.
[[nodiscard]] ColourScale count_scale(double most);

/// The picture of one of the image's layers, as large as its window and the legend. Precondition: layer.aov->picture is
/// one.
[[nodiscard]] Image layer_picture(const Image& image, const Layer& layer);

}  // namespace isl::render
