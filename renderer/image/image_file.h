// A picture → a file of the format that the name asks for. Integer formats (png, tif, jpg, ppm) hold sRGB code values,
// clipped; hdr and exr hold linear light. Only exr holds the layers, as `depth.Z`, `normal.X`, … .
#pragma once

#include "renderer/image/image.h"
#include "renderer/image/image_module.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isl::render {

struct ImageFileOptions {
  /// Name and value, in the order to keep: what made the picture. Never times, paths or thread counts.
  std::vector<std::pair<std::string, std::string>> metadata;
  bool exr_float = false;  ///< colour in 32 bits instead of 16; layers are always 32
  /// A channel of integer formats: 8 or 16; 0 is the most that the format holds. Without meaning for hdr and exr.
  int bits = 0;
  int threads = 1;  ///< how many may work on it; the bytes are the same
};

/// The format that a file's name asks for, in lower case ("png"); "" if there is none that can be written.
[[nodiscard]] std::string image_format_of(std::string_view path);

/// The formats, as a message may list them.
inline constexpr std::string_view kImageFormats = "png, exr, tif, jpg, ppm, hdr";

/// Whether a channel of the format can be a whole number of so many bits: png and tif 8 or 16, jpg and ppm 8.
[[nodiscard]] bool format_holds_bits(std::string_view format, int bits);

/// Whether the format holds linear light in floating point, so that it has no such number of bits.
[[nodiscard]] bool is_linear_format(std::string_view format);

/// The file's bytes in memory: the same for the same picture and options. Precondition: the format is one of
/// kImageFormats and holds `options.bits`.
[[nodiscard]] EncodedFile encode_image(const Image& image, std::string_view format, const ImageFileOptions& options);

}  // namespace isl::render
