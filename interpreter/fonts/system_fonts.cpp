#include "interpreter/fonts/system_fonts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string>

namespace isl::interpreter {
namespace {

namespace fs = std::filesystem;

/// More than any system has; a folder that links to itself ends here.
constexpr std::size_t kMostFiles = 20000;
constexpr int kMostFolders = 6;  ///< one in another

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool is_font_name(const fs::path& file) {
  const std::string ending = in_lower_case(file.extension().string());
  return ending == ".ttf" || ending == ".otf" || ending == ".ttc" || ending == ".pfb";
}

/// The folders of fonts by freedesktop's convention and the older one of X, the user's before the system's.
std::vector<fs::path> font_folders() {
  std::vector<fs::path> folders;
  if (const char* const home = std::getenv("HOME"); home && *home != 0) {
    folders.push_back(fs::path(home) / ".local/share/fonts");
    folders.push_back(fs::path(home) / ".fonts");
  }
  folders.emplace_back("/usr/local/share/fonts");
  folders.emplace_back("/usr/share/fonts");
  return folders;
}

}  // namespace

const std::vector<fs::path>& SystemFonts::files() {
  if (is_listed_) return files_;
  is_listed_ = true;
  for (const fs::path& folder : font_folders()) {
    std::error_code error;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
    const std::size_t first = files_.size();
    for (; !error && at != fs::recursive_directory_iterator() && files_.size() < kMostFiles; at.increment(error)) {
      if (at.depth() >= kMostFolders) at.disable_recursion_pending();
      std::error_code ignored;
      if (is_font_name(at->path()) && at->is_regular_file(ignored)) files_.push_back(at->path());
    }
    // Folders list their files in any order; the choice must not depend on it.
    std::sort(files_.begin() + static_cast<std::ptrdiff_t>(first), files_.end());
  }
  return files_;
}

fs::path SystemFonts::find(std::string_view name) {
  const std::string wanted = in_lower_case(name);
  for (const fs::path& file : files()) {
    const std::string own = in_lower_case(file.filename().string());
    if (own == wanted || own == wanted + ".ttf" || own == wanted + ".otf") return file;
  }
  return {};
}

fs::path SystemFonts::substitute_for(std::string_view name) {
  static constexpr std::array kSerif = {"LiberationSerif-Regular.ttf", "DejaVuSerif.ttf"};
  static constexpr std::array kSans = {"LiberationSans-Regular.ttf", "DejaVuSans.ttf"};
  const std::string wanted = in_lower_case(fs::path(name).filename().string());
  const bool is_serif = wanted.find("tim") != std::string::npos || wanted.find("serif") != std::string::npos ||
                        wanted.find("roman") != std::string::npos;
  for (const auto& list : {is_serif ? kSerif : kSans, is_serif ? kSans : kSerif}) {
    for (const char* const candidate : list) {
      if (fs::path found = find(candidate); !found.empty()) return found;
    }
  }
  return files().empty() ? fs::path() : files().front();
}

}  // namespace isl::interpreter
