// The last line of a render, for people and for the logs of scripts.
#pragma once

#include "renderer/image/image.h"

#include <string>
#include <vector>

namespace isl::cli {

/// `isl: a.png, b.exr, 800x600, 1.94 s`, without a line end; for a cropped picture `200x100 of 800x600`.
[[nodiscard]] std::string closing_line(const std::vector<std::string>& names, const render::Image& image,
                                       double seconds);

}  // namespace isl::cli
