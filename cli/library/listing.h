// The output of `isl library`: the overview, a file and an entry as text for a terminal, and all of them as JSON.
#pragma once

#include "cli/library/catalogue.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace isl::cli {

/// Every file with a sentence about it, and the names that it declares.
[[nodiscard]] std::string overview_text(const Catalogue& catalogue);

/// A file's first comment, and its entries with their parameters and texts.
[[nodiscard]] std::string library_text(const LibraryFile& file);

/// All about an entry, with the line that includes its file, and its example.
[[nodiscard]] std::string entry_text(const LibraryFile& file, const LibraryEntry& entry);

/// The same as JSON: the file with these of its entries.
[[nodiscard]] nlohmann::ordered_json library_json(const LibraryFile& file, const std::vector<LibraryEntry>& entries);

}  // namespace isl::cli
