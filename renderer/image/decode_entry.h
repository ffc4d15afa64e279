// The class that an image module must supply to decode files; decode_entry.cpp makes the C interface of decode_abi.h
// from it.
#pragma once

#include "renderer/image/decode_abi.h"

#include <memory>
#include <span>

namespace isl::render {

class PictureReader {
 public:
  virtual ~PictureReader() = default;
  /// Throws a std::exception whose text says why the pixels cannot be read.
  virtual void read(void* values) = 0;
};

/// Fills the header. Throws a std::exception whose text says why the file cannot be read.
[[nodiscard]] std::unique_ptr<PictureReader> open_picture(std::span<const unsigned char> bytes, const char* format,
                                                          IslPicture& header);

}  // namespace isl::render
