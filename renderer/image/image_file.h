// Converts a picture to a file of the format that the name asks for. Integer formats (png, tif, jpg, ppm) hold sRGB
// code values, clipped; hdr and exr hold linear light. Only exr holds the layers, as `depth.Z`, `normal.X`, … .
#pragma once

#include "renderer/image/image.h"
#include "renderer/image/image_module.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isl::render {

struct ImageFileOptions {
  /// Names and values, in the order in which they are written. They describe what made the picture, but never times,
  /// paths or thread counts.
  std::vector<std::pair<std::string, std::string>> metadata;
  bool exr_float = false;  ///< colour in 32 bits instead of 16; layers always have 32
  /// Bits of a channel in integer formats: 8 or 16; 0 is the most that the format holds. Ignored for hdr and exr.
  int bits = 0;
  int threads = 1;  ///< most threads that work on it; the bytes are the same for any number
};

/// The format that a file's name asks for, in lower case ("png"); "" if there is none that can be written.
[[nodiscard]] std::string image_format_of(std::string_view path);

/// The formats, as a message may list them.
inline constexpr std::string_view kImageFormats = "png, exr, tif, jpg, ppm, hdr";

/// True if a channel of the format can be a whole number of this many bits: 8 or 16 for png and tif, 8 for jpg and ppm.
[[nodiscard]] bool format_holds_bits(std::string_view format, int bits);

/// True if the format holds linear light in floating point, so that it has no number of bits.
[[nodiscard]] bool is_linear_format(std::string_view format);

/// The file's bytes in memory, the same for the same picture and options. Precondition: the format is one of
/// kImageFormats and holds `options.bits`.
[[nodiscard]] EncodedFile encode_image(const Image& image, std::string_view format, const ImageFileOptions& options);

}  // namespace isl::render
