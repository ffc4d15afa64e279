// A texture in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/texture.h"

#include <nlohmann/json.hpp>

namespace isl::scene {

[[nodiscard]] nlohmann::ordered_json texture_json(const Texture& texture);

}  // namespace isl::scene
