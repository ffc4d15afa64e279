// Camera and lights in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/camera.h"
#include "renderer/scene/light.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

[[nodiscard]] nlohmann::ordered_json camera_json(const Camera& camera);
/// The light without its origin.
[[nodiscard]] nlohmann::ordered_json light_json(const Light& light);

}  // namespace isl::scene
