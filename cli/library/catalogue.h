// The files of the standard library with their comments, and the search for a name in them. Knows the folder and no
// output.
#pragma once

#include "cli/library/library_comments.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

struct LibraryFile {
  std::string name;                   ///< as `#include` takes it
  std::vector<std::string> head;      ///< lines of the comment at its beginning
  std::vector<LibraryEntry> entries;  ///< none for a file of POV-Ray's names

  /// False for a file that has the name and the identifiers of one of POV-Ray's, which end in `.inc`.
  [[nodiscard]] bool is_ours() const { return name.ends_with(".isl"); }
};

/// The answer to a name: a file of the catalogue, and one of its entries if that has the name.
struct LibraryMatch {
  const LibraryFile& file;
  const LibraryEntry* entry = nullptr;
};

class Catalogue {
 public:
  /// Reads all `.isl` and `.inc` files of the folder, which are few and small.
  explicit Catalogue(const std::filesystem::path& folder);

  /// The reason why a file or the folder could not be read, or "".
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  /// Ours first, each kind by name.
  [[nodiscard]] const std::vector<LibraryFile>& files() const { return files_; }

  /// A file, with or without its extension, where ours come first; else a macro or a declaration.
  [[nodiscard]] std::optional<LibraryMatch> find(std::string_view name) const;

  /// The known name nearest to `name`, if one is near.
  [[nodiscard]] std::optional<std::string> similar(std::string_view name) const;

 private:
  std::vector<LibraryFile> files_;
  std::string trouble_;
};

}  // namespace isl::cli
