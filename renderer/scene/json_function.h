// Functions in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/function.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace isl::scene {

/// The functions in order, followed by the others that they call; `calls` has indices into this list.
[[nodiscard]] nlohmann::ordered_json functions_json(const std::vector<FunctionPointer>& functions);

}  // namespace isl::scene
