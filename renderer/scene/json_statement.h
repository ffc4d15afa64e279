// Statements of single effects in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/statement.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::scene {

/// The fields that differ from their defaults.
[[nodiscard]] nlohmann::ordered_json statement_json(const Statement& statement);

}  // namespace isl::scene
