// Which file of the search path declares a name: for the message about an undeclared one, "`White` is declared in
// `colors.inc`". The files are read when the first such message is made, so that the answer is never older than they
// are. Their text is only searched for directives, not parsed.
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
  /// The `.inc` files in these folders, not below them; of two that declare a name the first counts, a file by the
  /// order of the folders, then by its name.
  explicit LibraryIndex(const std::vector<std::filesystem::path>& folders);

  /// The file's name as `#include` takes it; none where no file declares the name.
  [[nodiscard]] std::optional<std::string_view> file_that_declares(std::string_view name) const;

 private:
  void add_file(const std::filesystem::path& file);

  std::vector<std::string> files_;
  std::unordered_map<std::string, std::size_t> file_of_;  ///< by name: its place in files_
};

/// The names that `#declare` and `#macro` give outside of macros in the text: what stands declared once it was
/// included.
[[nodiscard]] std::vector<std::string_view> names_declared_in(std::string_view text);

}  // namespace isl::grammar
