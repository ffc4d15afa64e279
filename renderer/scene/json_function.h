// Functions in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/function.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace isl::scene {

/// The functions in order, then those that they call and that are not among them; `calls` are numbers in this list.
[[nodiscard]] nlohmann::ordered_json functions_json(const std::vector<FunctionPointer>& functions);

}  // namespace isl::scene
