// Textures with their parts, and interiors, in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/database.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

/// The texture and its finish, which is not in a list of its own in the dump.
[[nodiscard]] nlohmann::ordered_json texture_json(const Texture& texture, const Finish& finish);
[[nodiscard]] nlohmann::ordered_json pigment_json(const PatternedPigment& pigment);
[[nodiscard]] nlohmann::ordered_json pigment_map_json(const PigmentMap& map);
[[nodiscard]] nlohmann::ordered_json normal_json(const Normal& normal);
[[nodiscard]] nlohmann::ordered_json normal_map_json(const NormalMap& map);
[[nodiscard]] nlohmann::ordered_json slope_map_json(const SlopeMap& map);
[[nodiscard]] nlohmann::ordered_json texture_pattern_json(const TexturePattern& pattern);
[[nodiscard]] nlohmann::ordered_json texture_map_json(const TextureMap& map);
[[nodiscard]] nlohmann::ordered_json interior_json(const Interior& interior);

/// A colour, or {"pigment": its number}.
[[nodiscard]] nlohmann::ordered_json pigment_reference(const Pigment& pigment);

}  // namespace isl::scene
