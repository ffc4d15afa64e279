// The index of names that the files of the search path declare, for the message about an undeclared one: "`White` is
// declared in `colors.inc`". The files are read when the first such message is made, so that the answer is up to date.
// Their text is only searched for directives, not parsed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isl::grammar {

class LibraryIndex {
 public:
  /// Indexes the `.inc` and `.isl` files directly in these folders. If two declare a name, the first one wins: files
  /// are ordered by folder, within it `.inc` before `.isl`, then by name.
  explicit LibraryIndex(const std::vector<std::filesystem::path>& folders);

  /// The file's name as `#include` takes it; none if no file declares the name.
  [[nodiscard]] std::optional<std::string_view> file_that_declares(std::string_view name) const;

 private:
  void add_file(const std::filesystem::path& file);

  std::vector<std::string> files_;
  std::unordered_map<std::string, std::size_t> file_of_;  ///< name → index in files_
};

/// The names that `#declare` and `#macro` define outside macros in the text: those that are declared after including
/// it.
[[nodiscard]] std::vector<std::string_view> names_declared_in(std::string_view text);

}  // namespace isl::grammar
