// Sky, fog and rainbows in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/atmosphere.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

[[nodiscard]] nlohmann::ordered_json sky_sphere_json(const SkySphere& sky);
[[nodiscard]] nlohmann::ordered_json fog_json(const Fog& fog);
[[nodiscard]] nlohmann::ordered_json rainbow_json(const Rainbow& rainbow);

}  // namespace isl::scene
