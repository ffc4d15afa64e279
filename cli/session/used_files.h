// The files that a scene depends on, with their hashes: for a picture's metadata and for `isl check`.
#pragma once

#include "grammar/loader.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace isl::cli {

/// `HASH NAME`, separated by line ends: the same on every machine.
[[nodiscard]] std::string files_text(std::span<const grammar::UsedFile> files);

/// One line for each file, which adds its place if the name does not show it.
[[nodiscard]] std::string files_table(std::span<const grammar::UsedFile> files);

[[nodiscard]] nlohmann::ordered_json files_json(std::span<const grammar::UsedFile> files);

}  // namespace isl::cli
