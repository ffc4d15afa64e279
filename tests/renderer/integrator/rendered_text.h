// Renders a scene given as text in a small size and returns the colour in the picture's middle.
#pragma once

#include "renderer/render.h"

#include <string_view>

namespace isl::test {

/// Traces one ray a pixel on one thread, unless the options say more, with `size` pixels a side. Fails the test if the
/// scene has errors or is refused.
[[nodiscard]] render::RenderResult rendered(std::string_view scene, int size = 17, render::RenderOptions options = {});

/// The linear colour of the middle pixel.
[[nodiscard]] render::Rgb middle_of(const render::Image& image);

}  // namespace isl::test
