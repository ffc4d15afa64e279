// The files that a scene is made of, with their hashes: as a picture's metadata has them, and as `isl check` tells
// them.
#pragma once

#include "grammar/loader.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace isl::cli {

/// `HASH NAME`, separated by line ends: the same on every machine.
[[nodiscard]] std::string files_text(std::span<const grammar::UsedFile> files);

/// A line for each, which says besides where the file lies if its name does not.
[[nodiscard]] std::string files_table(std::span<const grammar::UsedFile> files);

[[nodiscard]] nlohmann::ordered_json files_json(std::span<const grammar::UsedFile> files);

}  // namespace isl::cli
