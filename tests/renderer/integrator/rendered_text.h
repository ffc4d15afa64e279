// A scene given as text, rendered small: what the picture's middle shows.
#pragma once

#include "renderer/render.h"

#include <string_view>

namespace isl::test {

/// One ray a pixel, `size` pixels a side. Fails the test for a scene with errors or one that is refused.
[[nodiscard]] render::RenderResult rendered(std::string_view scene, int size = 17, render::RenderOptions options = {});

/// The linear colour of the middle pixel.
[[nodiscard]] render::Rgb middle_of(const render::Image& image);

}  // namespace isl::test
