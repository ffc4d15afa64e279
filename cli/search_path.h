// Where `#include` looks after the including file's folder, and where the program's own files are.
#pragma once

#include <filesystem>
#include <vector>

namespace isl::cli {

/// The libraries written in the language: `../share/isl` beside the folder of the executable, in a build tree as where
/// it is installed. Empty when there is none.
[[nodiscard]] std::filesystem::path stdlib_folder();

/// `asked` (each -I), then the folders of the environment variable ISL_PATH (separated by `:`), then the stdlib.
[[nodiscard]] std::vector<std::filesystem::path> include_search_path(const std::vector<std::filesystem::path>& asked);

}  // namespace isl::cli
