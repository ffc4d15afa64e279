#include "cli/library/catalogue.h"

#include "cli/output/printable_text.h"
#include "grammar/suggest.h"
#include "grammar/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <tuple>

namespace isl::cli {
namespace {

namespace fs = std::filesystem;

/// A hundred times the largest library.
constexpr std::size_t kMaxLibraryBytes = 4 << 20;

/// The names of the libraries in a folder, ours first.
std::vector<std::string> libraries_in(const fs::path& folder, std::error_code& error) {
  std::vector<std::string> names;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    const std::string extension = file->path().extension().string();
    if (extension == ".isl" || extension == ".inc") names.push_back(file->path().filename().string());
  }
  std::ranges::sort(names, {}, [](const std::string& name) { return std::tuple(!name.ends_with(".isl"), name); });
  return names;
}

std::string_view stem_of(std::string_view file) { return file.substr(0, file.find_last_of('.')); }

}  // namespace

Catalogue::Catalogue(const fs::path& folder) {
  std::error_code error;
  const std::vector<std::string> names = libraries_in(folder, error);
  if (error) trouble_ = fmt::format("cannot read the folder `{}`: {}", visible_name(folder.string()), error.message());
  for (const std::string& name : names) {
    const grammar::TextFile file = grammar::read_text_file(folder / name, kMaxLibraryBytes);
    if (!file.trouble.empty()) {
      trouble_ = fmt::format("cannot read `{}`: {}", visible_name((folder / name).string()), file.trouble);
      return;
    }
    LibraryFile& library = files_.emplace_back();
    library.name = name;
    library.head = head_comment(file.text);
    if (library.is_ours()) library.entries = library_entries(stem_of(name), file.text);
  }
}

std::optional<LibraryMatch> Catalogue::find(std::string_view name) const {
  for (const LibraryFile& file : files_) {
    if (name == file.name || name == stem_of(file.name)) return LibraryMatch{file};
  }
  for (const LibraryFile& file : files_) {
    const auto entry = std::ranges::find(file.entries, name, &LibraryEntry::name);
    if (entry != file.entries.end()) return LibraryMatch{file, &*entry};
  }
  return std::nullopt;
}

std::optional<std::string> Catalogue::similar(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const LibraryFile& file : files_) {
    known.insert(known.end(), {file.name, stem_of(file.name)});
    for (const LibraryEntry& entry : file.entries) known.push_back(entry.name);
  }
  const std::optional<std::string_view> nearest = grammar::closest(name, known);
  return nearest ? std::optional(std::string(*nearest)) : std::nullopt;
}

}  // namespace isl::cli
