// The primitive database as JSON, for `isl dump --stage database` and for golden tests. Stable: the same database gives
// the same text, records in their order and fields in the order of database.h. Fields with a default that means "not
// set" are left out.
#pragma once

#include "renderer/scene/database.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace isl::scene {

/// Describes the origin of a primitive; null if it is unknown. The callers that know the scene's text (cli, tests) pass
/// this function.
using DescribeOrigin = std::function<nlohmann::ordered_json(OriginId)>;

[[nodiscard]] nlohmann::ordered_json to_json(const Database& database, const DescribeOrigin& describe_origin = {});

/// The JSON as text. Values that fit are on one line, which most records do. The text ends with a newline.
[[nodiscard]] std::string dump_json(const Database& database, const DescribeOrigin& describe_origin = {});

}  // namespace isl::scene
