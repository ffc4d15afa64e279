// Opens files that certainly lie below a folder: this step enforces a rule about folders even if the file system
// changes meanwhile. It knows folders and names; file_access.h decides which folders are allowed.
#pragma once

#include "base/files/descriptor.h"

#include <filesystem>

namespace isl::grammar {

/// A folder that was found once and is kept open: renaming it or putting a link in its place changes nothing.
class Folder {
 public:
  /// Not open if `path` is not a folder or is not accessible. "" is the current folder.
  explicit Folder(const std::filesystem::path& path);

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  /// Absolute path, without links.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// True if an absolute path without links is the folder or leads below it.
  [[nodiscard]] bool holds(const std::filesystem::path& canonical) const;
  /// Such a path relative to the folder; empty for the folder itself. Precondition: the folder holds it.
  [[nodiscard]] std::filesystem::path below(const std::filesystem::path& canonical) const;

  /// Opens the folder itself or one below it, by its path `canonical`. Walks from the folder name by name and follows
  /// no link, so that the call fails (with `errno`) if a link was put in after `canonical` was found. The result can be
  /// the starting point of other calls, but cannot be read.
  [[nodiscard]] Descriptor open_folder(const std::filesystem::path& canonical) const;

 private:
  Descriptor descriptor_;
  std::filesystem::path path_;
};

}  // namespace isl::grammar
