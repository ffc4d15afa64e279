#include "cli/search_path.h"

#include "base/program_folder.h"

#include <cstdlib>
#include <string_view>
#include <system_error>

namespace isl::cli {

namespace fs = std::filesystem;

fs::path stdlib_folder() {
  std::error_code error;
  const fs::path program = program_folder(error);
  if (error) return {};
  fs::path folder = fs::weakly_canonical(program / ".." / "share" / "isl", error);
  return !error && fs::is_directory(folder, error) ? folder : fs::path();
}

std::vector<fs::path> include_search_path(const std::vector<fs::path>& asked) {
  std::vector<fs::path> folders = asked;
  const char* const variable = std::getenv("ISL_PATH");
  std::string_view rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
  if (fs::path stdlib = stdlib_folder(); !stdlib.empty()) folders.push_back(std::move(stdlib));
  return folders;
}

}  // namespace isl::cli
