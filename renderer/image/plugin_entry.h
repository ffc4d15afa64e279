// The function that an image module must supply; plugin_entry.cpp makes the C interface of image_abi.h from it.
#pragma once

#include "renderer/image/image_abi.h"

#include <vector>

namespace isl::render {

/// The file's bytes. Throws a std::exception whose text says why it could not encode the picture.
[[nodiscard]] std::vector<unsigned char> encode_picture(const IslImage& image);

/// The date in formats that would otherwise store the time of writing, so that the same picture is the same bytes.
inline constexpr const char* kFixedDate = "1970:01:01 00:00:00";

}  // namespace isl::render
