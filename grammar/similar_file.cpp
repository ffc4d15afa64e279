#include "grammar/similar_file.h"

#include "grammar/suggest.h"

#include <fmt/format.h>
#include <strings.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <functional>
#include <system_error>
#include <vector>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;
using MayRead = std::function<bool(const fs::path&)>;

/// Limit of the entries of one folder that are examined: a message is not worth more time.
constexpr std::size_t kMaxEntries = 10'000;

/// A path in Windows' form, with `/` instead of `\` and without the drive's letter.
std::string with_slashes(std::string_view name) {
  const bool has_drive = name.size() > 1 && std::isalpha(static_cast<unsigned char>(name[0])) != 0 && name[1] == ':';
  std::string text(has_drive ? name.substr(2) : name);
  std::replace(text.begin(), text.end(), '\\', '/');
  return text;
}

/// The entries of a readable folder; none if it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder, const MayRead& may_read) {
  std::error_code error;
  const fs::path canonical = fs::canonical(folder.empty() ? "." : folder, error);
  if (error || !may_read(canonical)) return {};
  std::vector<fs::path> found;
  fs::directory_iterator entry(canonical, error);
  for (; !error && entry != fs::directory_iterator() && found.size() < kMaxEntries; entry.increment(error))
    found.push_back(entry->path());
  return found;
}

bool is_readable_file(const fs::path& path, const MayRead& may_read) {
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return !error && fs::is_regular_file(canonical, error) && may_read(canonical);
}

/// The entry of a readable folder that equals `part` apart from the case of letters; empty if there is none.
fs::path entry_like(const fs::path& folder, const fs::path& part, const MayRead& may_read) {
  std::error_code error;
  if (fs::exists(folder / part, error)) return part;
  for (const fs::path& entry : entries_of(folder, may_read)) {
    if (::strcasecmp(entry.filename().c_str(), part.c_str()) == 0) return entry.filename();
  }
  return {};
}

/// The path below `folder` of a readable file that equals `name` apart from the case of letters.
fs::path path_like(const fs::path& folder, const fs::path& name, const MayRead& may_read) {
  fs::path below;
  for (const fs::path& part : name.relative_path()) {
    const fs::path entry = entry_like(folder / below, part, may_read);
    if (entry.empty()) return {};
    below /= entry;
  }
  return is_readable_file(folder / below, may_read) ? below : fs::path();
}

/// The path below one of the folders of the readable file whose name is nearest to that of `path`, which is misspelt;
/// empty if none is near.
fs::path path_nearest_to(const fs::path& path, const std::vector<fs::path>& folders, const MayRead& may_read) {
  std::vector<std::string> names;
  for (const fs::path& folder : folders) {
    for (const fs::path& entry : entries_of(folder / path.parent_path(), may_read)) {
      if (is_readable_file(entry, may_read)) names.push_back(entry.filename().string());
    }
  }
  std::ranges::sort(names);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const auto nearest = closest(path.filename().native(), candidates);
  return nearest ? path.parent_path() / *nearest : fs::path();
}

}  // namespace

std::string hint_of_similar_file(std::string_view name, const std::vector<fs::path>& folders, const MayRead& may_read) {
  const bool has_backslash = name.find('\\') != std::string_view::npos;
  const std::string slashed = with_slashes(name);
  const fs::path path(slashed);
  const auto hint = [&](const fs::path& folder, const fs::path& found) {
    std::string reason;
    if (has_backslash) reason = "; folders are separated by `/`";
    const bool is_same_path = ::strcasecmp(found.c_str(), path.c_str()) == 0;
    const bool has_other_case = is_same_path ? found != path : found.filename() != path.filename();
    if (!has_backslash && has_other_case) reason = "; file names distinguish capitals";
    const std::string place = folder.empty() ? "." : folder.string();
    return fmt::format("there is `{}` in {}: write that name{}", found.string(), place, reason);
  };
  for (const fs::path& folder : folders) {
    if (path.is_absolute()) break;
    if (const fs::path found = path_like(folder, path, may_read); !found.empty()) return hint(folder, found);
  }
  for (const fs::path& folder : folders) {
    if (const fs::path found = path_like(folder, path.filename(), may_read); !found.empty()) return hint(folder, found);
  }
  if (const fs::path found = path_nearest_to(path, folders, may_read); !found.empty())
    return fmt::format("did you mean `{}`?", found.string());
  return has_backslash ? "separate folders by `/`, and put the file beside the scene" : "";
}

}  // namespace isl::grammar
