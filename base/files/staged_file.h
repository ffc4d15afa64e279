// Files that are either complete or not there at all: each is written under another name in its folder, then renamed.
// So neither a link that is put in its place meanwhile nor another name of the same file is ever written through.
#pragma once

#include "base/files/descriptor.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isl {

/// A folder that files are written to. It is kept open: renaming it, or putting a link in its place, changes nothing.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& path);
  /// The folder that is open already; `path` is for messages.
  OutputFolder(const Descriptor& folder, std::filesystem::path path);

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  [[nodiscard]] int get() const { return descriptor_.get(); }
  [[nodiscard]] int error() const { return error_; }  ///< `errno` of the opening
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// The reason why no file `name` can be written here, or "": it is a folder or a device, or it or the folder may not
  /// be written. Leaves nothing behind.
  [[nodiscard]] std::string why_not_writable(const std::string& name) const;

  /// Makes the renaming of files survive a power cut. File systems that cannot do this are ignored.
  void sync() const;
  /// Waits until all that was written to its file system is on the disk; false if that failed.
  [[nodiscard]] bool sync_file_system() const;

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  int error_ = 0;
};

/// A file that is complete under a temporary name in its folder (temporary_file.h). It is removed unless it takes its
/// place.
class StagedFile {
 public:
  enum class Sync : std::uint8_t { now, later };

  /// Writes `bytes`, and waits until they are on the disk unless sync() will; error() tells whether that failed. The
  /// permissions of the file that will be replaced stay.
  StagedFile(std::shared_ptr<const OutputFolder> folder, std::string name, std::span<const unsigned char> bytes,
             Sync when);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// The reason of a failure, without the file's name, or "".
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const OutputFolder& folder() const { return *folder_; }
  [[nodiscard]] std::filesystem::path path() const { return folder_->path() / name_; }

  /// Waits until the bytes are on the disk. Returns the reason of a failure, or "". Precondition: error() is "".
  [[nodiscard]] std::string sync() const;
  /// Makes it the content of its place; the former content stays untouched unless this succeeds. Returns the reason of
  /// a failure, or "". Precondition: error() is "".
  [[nodiscard]] std::string take_place();
  /// The bytes, as far as they can be read again.
  [[nodiscard]] std::vector<unsigned char> content() const;

 private:
  std::shared_ptr<const OutputFolder> folder_;
  std::string name_;
  std::string temporary_;  ///< empty: there is nothing to remove
  std::string error_;
};

/// Writes all bytes to an open file; false, with `errno`, if that failed.
[[nodiscard]] bool write_all(int descriptor, std::span<const unsigned char> bytes);

}  // namespace isl
