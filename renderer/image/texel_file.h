// Decodes the bytes of an image file into texels, by the module of its format.
#pragma once

#include "base/run_limits.h"
#include "renderer/patterns/kinds/texels.h"
#include "renderer/scene/image.h"

#include <memory>
#include <string>
#include <string_view>

namespace isl::render {

/// Texels, or the reason why there are none (lower case, no full stop).
struct DecodedTexels {
  std::shared_ptr<const Texels> texels;
  std::string problem;
  bool is_too_large = false;  ///< the reason is the limit of memory
};

/// The greatest width or height.
inline constexpr int kMostTexelsOfSide = 1 << 16;

/// `type` is the one that the scene names; if it names none, the file's extension says it. Only that format is tried.
/// The pixels are charged to the run's budget before they take memory, and stay so until nobody holds them.
[[nodiscard]] DecodedTexels decode_texels(std::string_view bytes, std::string_view file, scene::ImageType type,
                                          const RunLimits& run);

}  // namespace isl::render
