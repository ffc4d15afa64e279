// A solid in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/database.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

/// The solid, with the content of the record that Solid::detail refers to in place of the number.
[[nodiscard]] nlohmann::ordered_json solid_json(const Database& database, const Solid& solid);

}  // namespace isl::scene
