// The pixels of an image file as the file has them, for lookups by patterns. Codes are kept as they are, of 8 or 16
// bits, and a table of what each code means (sampled_image.h) is applied where a texel is looked up: a large photograph
// takes 3 bytes a pixel instead of 16, so that more of it stays in the caches, and the table of 256 floats is always
// there. Images of one file share the texels, however differently they decode them.
#pragma once

#include "base/budget.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::render {

/// How a file's codes from 0 to 1 mean light. `working`: they are values of the scene's working space.
enum class Transfer : std::uint8_t { working, linear, srgb, power };

struct Texels {
  /// `index`: one channel of 8 bits, the number of a colour of the palette.
  enum class Sample : std::uint8_t { index, bits8, bits16, real };
  using PaletteColour = std::array<std::uint8_t, 4>;  ///< red, green, blue, alpha

  int width = 0, height = 0;
  int channels = 3;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
  Sample sample = Sample::bits8;
  std::vector<std::byte> values;  ///< row by row from the top, the channels of a texel side by side
  std::vector<PaletteColour> palette;
  Transfer transfer = Transfer::srgb;  ///< as the file states it, or as its format has it
  double gamma = 1;                    ///< of Transfer::power: light = code^gamma
  bool states_transfer = false;        ///< the file itself states it
  bool hides_palette = false;          ///< the file has a palette, but only colours of it could be read
  bool is_premultiplied = false;       ///< colours are multiplied by alpha
  Charge charge{};                     ///< of `values`

  [[nodiscard]] bool has_alpha() const { return channels == 2 || channels == 4; }
};

}  // namespace isl::render
