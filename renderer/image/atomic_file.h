// Files that are either complete or not there at all: each is written under another name in its folder, then renamed.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace isl::render {

/// The reason why `path` could not be written, or "" if it could: the folder is missing or not writable, the path is a
/// folder or a device, or a file that may not be written. Leaves nothing behind. Texts are in lower case and name the
/// path.
[[nodiscard]] std::string why_not_writable(const std::string& path);

/// A file that is complete and synced under a name of its own beside its final place. It is removed unless it takes
/// that place.
class StagedFile {
 public:
  /// Writes `bytes`; error() tells whether that failed.
  StagedFile(const std::string& path, std::span<const unsigned char> bytes);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// The reason of a failure, or "".
  [[nodiscard]] const std::string& error() const { return error_; }

  /// Makes it the content of `path`; the former content stays untouched unless this succeeds. A symbolic link is
  /// followed. Returns the reason of a failure, or "". Precondition: error() is "".
  [[nodiscard]] std::string take_place();

 private:
  [[nodiscard]] bool write_all(std::span<const unsigned char> bytes) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;  ///< −1 if there is nothing to remove
  std::string error_;
};

/// Both steps at once: `bytes` become the content of `path`, or nothing changes. Returns the reason of a failure, or
/// "".
[[nodiscard]] std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes);

}  // namespace isl::render
