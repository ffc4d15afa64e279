// The primitive database as JSON, for `isl dump --stage database` and for golden tests. Stable: the same database gives
// the same text, records in their order and fields in the order of database.h. What a field's default means "nothing
// said" is left out.
#pragma once

#include "renderer/scene/database.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace isl::scene {

/// Says where a primitive comes from; null for nothing to say. Whoever knows places (cli, tests) gives one.
using DescribeOrigin = std::function<nlohmann::ordered_json(OriginId)>;

[[nodiscard]] nlohmann::ordered_json to_json(const Database& database, const DescribeOrigin& describe_origin = {});

/// The same as text: what fits is on one line, so that a record is mostly a line. Ends with a newline.
[[nodiscard]] std::string dump_json(const Database& database, const DescribeOrigin& describe_origin = {});

}  // namespace isl::scene
