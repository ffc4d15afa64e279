// What a module that encodes pictures supplies; plugin_entry.cpp makes the C interface of image_abi.h of it.
#pragma once

#include "renderer/image/image_abi.h"

#include <vector>

namespace isl::render {

/// The file's bytes. Throws a std::exception whose text says why there are none.
[[nodiscard]] std::vector<unsigned char> encode_picture(const IslImage& image);

/// Written into formats that would otherwise note the time of writing: the same picture is the same bytes.
inline constexpr const char* kFixedDate = "1970:01:01 00:00:00";

}  // namespace isl::render
