// The last lines of a render, for people and for the logs of scripts.
#pragma once

#include "renderer/image/image.h"
#include "renderer/render.h"

#include <string>
#include <vector>

namespace isl::cli {

/// `isl: a.png, b.exr, 800x600, 1.94 s`, without a line end; for a cropped picture `200x100 of 800x600`.
[[nodiscard]] std::string closing_line(const std::vector<std::string>& names, const render::Image& image,
                                       double seconds);

/// "3 pixels could be off by more than the tolerance (2 undecided, 1 refuted); …"; empty if every pixel is certain.
[[nodiscard]] std::string uncertain_line(const render::RenderStatistics& statistics);

/// How many samples are left out because their colour is no finite number, and where; empty if none is.
[[nodiscard]] std::string lost_line(const render::LostSamples& lost);

/// How many pixels have more noise than was asked for, although they have all samples; empty if none has.
[[nodiscard]] std::string noisy_line(const render::RenderStatistics& statistics);

}  // namespace isl::cli
