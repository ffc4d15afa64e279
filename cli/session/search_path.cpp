#include "cli/session/search_path.h"

#include "base/program_folder.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace isl::cli {

namespace fs = std::filesystem;

namespace {

/// The folders for files that programs share: of the system, of Homebrew on Linux and both kinds of Macs, of MacPorts.
constexpr std::array kPrefixes{"/usr/share", "/usr/local/share", "/home/linuxbrew/.linuxbrew/share",
                               "/opt/homebrew/share", "/opt/local/share"};
/// The version of our language comes first, then the newer, then the older; some packages name none.
constexpr std::array kVersions{"povray-3.7", "povray-3.8", "povray-3.6", "povray"};
/// The folder of the fonts that the include folder of some packages links to.
constexpr const char* kFonts = "fonts/truetype/povray";

void append_folders(const char* list, std::vector<fs::path>& folders) {
  std::string_view rest = list == nullptr ? "" : list;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
}

}  // namespace

fs::path stdlib_folder() {
  std::error_code error;
  const fs::path program = program_folder(error);
  if (error) return {};
  fs::path folder = fs::weakly_canonical(program / ".." / "share" / "isl", error);
  return !error && fs::is_directory(folder, error) ? folder : fs::path();
}

std::vector<fs::path> system_libraries() {
  std::vector<fs::path> folders;
  if (const char* const named = std::getenv("ISL_SYSTEM_LIBRARIES")) {
    append_folders(named, folders);
    return folders;
  }
  std::error_code error;
  for (const char* const version : kVersions) {
    for (const fs::path prefix : kPrefixes) {
      const fs::path include = prefix / version / "include";
      if (!fs::is_directory(include, error)) continue;
      folders.push_back(include);
      if (fs::is_directory(prefix / kFonts, error)) folders.push_back(prefix / kFonts);
      return folders;
    }
  }
  return folders;
}

std::vector<fs::path> include_search_path(const std::vector<fs::path>& asked, SystemLibraries system) {
  std::vector<fs::path> folders = asked;
  append_folders(std::getenv("ISL_PATH"), folders);
  const std::vector<fs::path> theirs = system == SystemLibraries::none ? std::vector<fs::path>() : system_libraries();
  if (system == SystemLibraries::before_ours) folders.insert(folders.end(), theirs.begin(), theirs.end());
  if (fs::path stdlib = stdlib_folder(); !stdlib.empty()) folders.push_back(std::move(stdlib));
  if (system == SystemLibraries::after_ours) folders.insert(folders.end(), theirs.begin(), theirs.end());
  return folders;
}

}  // namespace isl::cli
