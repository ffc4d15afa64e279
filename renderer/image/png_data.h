// The image data of a PNG file: rows filtered and compressed, in strips on several threads. Knows nothing of chunks.
#pragma once

#include "renderer/image/image_abi.h"

#include <vector>

namespace isl::render {

/// A zlib stream of all rows, in pieces that follow one another. The bytes are the same for any number of threads.
/// Preconditions: planes of 8 or 16 bits, all of one type; threads ≥ 1. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::vector<unsigned char>> png_data(const IslImage& image, int threads);

}  // namespace isl::render
