// Patterns, warps and pictures in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/image.h"
#include "renderer/scene/pattern.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

[[nodiscard]] nlohmann::ordered_json pattern_json(const Pattern& pattern);
[[nodiscard]] nlohmann::ordered_json turbulence_json(const Turbulence& turbulence);
[[nodiscard]] nlohmann::ordered_json image_json(const Image& image);

}  // namespace isl::scene
