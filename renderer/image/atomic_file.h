// Files that are there wholly or not at all: written beside their place under another name, then renamed over it.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace isl::render {

/// Why `path` could not be written, or "" if it could: the folder is missing or closed to us, the place is a folder or
/// a device, or a file that we may not write. Leaves nothing behind. Texts are in lower case and name the path.
[[nodiscard]] std::string why_not_writable(const std::string& path);

/// A file that is whole and synced under a name of its own beside its place. It is gone again unless it takes the
/// place.
class StagedFile {
 public:
  /// Writes `bytes`; error() tells how that went.
  StagedFile(const std::string& path, std::span<const unsigned char> bytes);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// What went wrong, or "".
  [[nodiscard]] const std::string& error() const { return error_; }

  /// Makes it the content of `path`; what was there before stays untouched unless this succeeds. A symbolic link is
  /// followed. Returns what went wrong, or "". Precondition: error() is "".
  [[nodiscard]] std::string take_place();

 private:
  [[nodiscard]] bool write_all(std::span<const unsigned char> bytes) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;  ///< −1: there is nothing to remove
  std::string error_;
};

/// Both steps at once: `bytes` become the content of `path`, or nothing changes. Returns what went wrong, or "".
[[nodiscard]] std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes);

}  // namespace isl::render
