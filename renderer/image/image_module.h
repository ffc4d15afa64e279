// Finds and loads the image modules, and calls them. The only place that knows of dynamic loading.
#pragma once

#include "renderer/image/image_abi.h"

#include <cstddef>
#include <string>
#include <vector>

namespace isl::render {

/// A file's bytes, or the reason of a failure (lower case, no full stop).
struct EncodedFile {
  std::vector<unsigned char> bytes;
  std::string error;  ///< empty on success
};

/// Encodes by the format's module (isl_png.so, isl_exr.so, else isl_image.so). A module is loaded when it is first
/// needed, from the executable's folder or else from ../lib/isl beside that. May be called from several threads.
[[nodiscard]] EncodedFile encode_by_module(const IslImage& image);

}  // namespace isl::render
