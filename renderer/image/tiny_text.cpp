#include "renderer/image/tiny_text.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace isl::render {
namespace {

/// The rows of a letter from the top; the leftmost of the five dots of a row is the highest bit.
struct Letter {
  char name;
  std::array<std::uint8_t, kLetterHeight> rows;
};

// clang-format off
constexpr Letter kLetters[] = {
    {'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    {'3', {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110}},
    {'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    {'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    {'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    {'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    {'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
    {'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    {'-', {0b00000, 0b00000, 0b00000, 0b01110, 0b00000, 0b00000, 0b00000}},
    {'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    {'a', {0b00000, 0b00000, 0b01110, 0b00001, 0b01111, 0b10001, 0b01111}},
    {'c', {0b00000, 0b00000, 0b01110, 0b10000, 0b10000, 0b10001, 0b01110}},
    {'d', {0b00001, 0b00001, 0b01101, 0b10011, 0b10001, 0b10001, 0b01111}},
    {'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
    {'f', {0b00110, 0b01001, 0b01000, 0b11100, 0b01000, 0b01000, 0b01000}},
    {'i', {0b00100, 0b00000, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'l', {0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'m', {0b00000, 0b00000, 0b11010, 0b10101, 0b10101, 0b10001, 0b10001}},
    {'n', {0b00000, 0b00000, 0b10110, 0b11001, 0b10001, 0b10001, 0b10001}},
    {'o', {0b00000, 0b00000, 0b01110, 0b10001, 0b10001, 0b10001, 0b01110}},
    {'p', {0b00000, 0b00000, 0b11110, 0b10001, 0b11110, 0b10000, 0b10000}},
    {'r', {0b00000, 0b00000, 0b10110, 0b11001, 0b10000, 0b10000, 0b10000}},
    {'s', {0b00000, 0b00000, 0b01111, 0b10000, 0b01110, 0b00001, 0b11110}},
    {'t', {0b01000, 0b01000, 0b11100, 0b01000, 0b01000, 0b01001, 0b00110}},
    {'u', {0b00000, 0b00000, 0b10001, 0b10001, 0b10001, 0b10011, 0b01101}},
    {'v', {0b00000, 0b00000, 0b10001, 0b10001, 0b10001, 0b01010, 0b00100}},
    {'x', {0b00000, 0b00000, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001}},
};
// clang-format on

void draw_dot(Image& image, int x0, int y0, int scale, const Rgb& colour) {
  for (int y = y0; y < y0 + scale; ++y) {
    for (int x = x0; x < x0 + scale; ++x) {
      if (x < 0 || y < 0 || x >= image.window.width() || y >= image.window.height()) continue;
      double* rgba = &image.rgba[4 * image.window.index(image.window.x0 + x, image.window.y0 + y)];
      for (int i = 0; i < 3; ++i) rgba[i] = colour[i];
    }
  }
}

}  // namespace

void draw_text(Image& image, int x, int y, std::string_view text, int scale, const Rgb& colour) {
  for (const char c : text) {
    ISL_DCHECK(c == ' ' || std::ranges::any_of(kLetters, [c](const Letter& letter) { return letter.name == c; }));
    for (const Letter& letter : kLetters) {
      if (letter.name != c) continue;
      for (int row = 0; row < kLetterHeight; ++row) {
        for (int column = 0; column < kLetterWidth - 1; ++column) {
          if (letter.rows[static_cast<std::size_t>(row)] >> (kLetterWidth - 2 - column) & 1) {
            draw_dot(image, x + column * scale, y + row * scale, scale, colour);
          }
        }
      }
    }
    x += kLetterWidth * scale;
  }
}

}  // namespace isl::render
