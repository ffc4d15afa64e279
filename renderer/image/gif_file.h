// Reads the first picture of a GIF file with the numbers of its colours. OpenImageIO reads the format, too, but tells
// only colours, and scenes choose textures, transparency and heights by the numbers.
//
// Format: "Graphics Interchange Format, Version 89a" (CompuServe, 1990); the pixels are compressed by Lempel, Ziv and
// Welch's method with codes of growing length.
#pragma once

#include "renderer/patterns/kinds/texels.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isl::render {

class GifFile {
 public:
  /// Reads everything before the pixels. The bytes must outlive this object.
  explicit GifFile(std::span<const unsigned char> bytes);

  /// Why the file cannot be read; "" if it can. Precondition of all below: there is no error.
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const std::vector<Texels::PaletteColour>& palette() const { return palette_; }
  /// Fills width × height numbers, row by row from the top; false on failure, and error() says why.
  [[nodiscard]] bool read(std::span<std::byte> numbers);

 private:
  [[nodiscard]] std::optional<int> byte();
  [[nodiscard]] std::optional<int> word();
  [[nodiscard]] bool read_palette(int flags);
  [[nodiscard]] bool read_extension();
  [[nodiscard]] bool skip_blocks();
  [[nodiscard]] bool read_header();
  /// The pixels' codes, with the lengths of their blocks taken out.
  [[nodiscard]] std::vector<unsigned char> codes();

  std::span<const unsigned char> rest_;
  std::string error_;
  int width_ = 0, height_ = 0;
  int transparent_ = -1;
  bool is_interlaced_ = false;
  std::vector<Texels::PaletteColour> palette_;
};

}  // namespace isl::render
