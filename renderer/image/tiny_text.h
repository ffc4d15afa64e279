// Draws a few words and numbers into a picture, as legends need them, without a library of fonts.
#pragma once

#include "renderer/image/image.h"
#include "renderer/shading/material.h"

#include <string_view>

namespace isl::render {

/// The size of a letter before it is enlarged: five columns and one between letters, seven rows.
inline constexpr int kLetterWidth = 6, kLetterHeight = 7;

/// Draws from the top left corner (x, y) of the image's window, every dot `scale` pixels wide. Parts outside the window
/// are cut off. Precondition: only spaces, digits, `. - +` and the small letters that legends use.
void draw_text(Image& image, int x, int y, std::string_view text, int scale, const Rgb& colour);

}  // namespace isl::render
