// The folders that `#include` searches after the including file's folder, and the folder of the program's own files.
#pragma once

#include "cli/options/options.h"

#include <filesystem>
#include <vector>

namespace isl::cli {

/// The libraries written in the language: `../share/isl` beside the folder of the executable, in a build tree as in an
/// installation. Empty when there is none.
[[nodiscard]] std::filesystem::path stdlib_folder();

/// POV-Ray's include files and their fonts if this system has them, read-only: of the folders that packages install
/// them to, those of the first version found (docs/language.md lists them); or the folders of the environment variable
/// ISL_SYSTEM_LIBRARIES, if it is set.
[[nodiscard]] std::vector<std::filesystem::path> system_libraries();

/// `asked` (each -I), then the folders of the environment variable ISL_PATH (separated by `:`), then the stdlib, with
/// the system's libraries after it, before it or not at all.
[[nodiscard]] std::vector<std::filesystem::path> include_search_path(const std::vector<std::filesystem::path>& asked,
                                                                     SystemLibraries system);

}  // namespace isl::cli
