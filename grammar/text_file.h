// Reading a source file whole: only regular files, only up to a size, only what looks like text. Knows no syntax.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace isl::grammar {

/// Tells whether a file is still the one that was read. All zero where there is none.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t bytes = 0;
  std::int64_t seconds = 0;  ///< of its last change
  std::int64_t nanoseconds = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

struct TextFile {
  std::string text;
  std::string trouble;  ///< why there is no text; empty when there is
  std::string hint;
  bool exists = false;
  FileStamp stamp;
};

/// Never waits for a pipe or a device: those are no scenes.
[[nodiscard]] TextFile read_text_file(const std::filesystem::path& file, std::size_t max_bytes);

/// The file `name` in the open folder `folder`; a link is refused, and so is what is no regular file, unopened.
[[nodiscard]] TextFile read_text_file_at(int folder, const std::string& name, std::size_t max_bytes);

/// The same of a file that may hold any bytes.
[[nodiscard]] TextFile read_bytes_at(int folder, const std::string& name, std::size_t max_bytes);

[[nodiscard]] TextFile read_standard_input(std::size_t max_bytes);

[[nodiscard]] FileStamp stamp_of(const std::filesystem::path& file);
/// The same of `name` in an open folder; a link's own.
[[nodiscard]] FileStamp stamp_at(int folder, const std::string& name);

}  // namespace isl::grammar
