// Opening files that certainly lie below a folder: the step that makes a rule about folders hold whatever happens to
// the file system meanwhile. Knows folders and names; which folders are allowed is file_access.h's.
#pragma once

#include "grammar/descriptor.h"

#include <filesystem>

namespace isl::grammar {

/// A folder that was found once and is kept open: whoever renames it or puts a link in its place changes nothing.
class Folder {
 public:
  /// Not open where `path` is no folder or closed to us. "" is the current folder.
  explicit Folder(const std::filesystem::path& path);

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  /// Absolute, without links.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether an absolute path without links leads below the folder, or to it.
  [[nodiscard]] bool holds(const std::filesystem::path& canonical) const;
  /// What such a path is called from the folder: relative, empty for the folder itself. Precondition: it is held.
  [[nodiscard]] std::filesystem::path below(const std::filesystem::path& canonical) const;

  /// The folder itself or one below it, whose path `canonical` is. Walks from the folder name by name and follows no
  /// link, so that a link put in after `canonical` was found makes it fail (`errno` tells). It can be used as the
  /// starting point of other calls, not read.
  [[nodiscard]] Descriptor open_folder(const std::filesystem::path& canonical) const;

 private:
  Descriptor descriptor_;
  std::filesystem::path path_;
};

}  // namespace isl::grammar
