// Finds and loads the image module, and calls it. The only place that knows of dynamic loading.
#pragma once

#include "renderer/image/image_abi.h"

#include <cstddef>
#include <string>
#include <vector>

namespace isl::render {

/// A file's bytes, or what went wrong (lower case, no full stop).
struct EncodedFile {
  std::vector<unsigned char> bytes;
  std::string error;  ///< empty on success
};

/// Encodes by the module, which is loaded at the first call: `isl_image.so` beside the executable, else in ../lib/isl
/// from there. May be called from several threads.
[[nodiscard]] EncodedFile encode_by_module(const IslImage& image);

}  // namespace isl::render
