// Reads a source file whole: only a regular file, only up to a size, only if it looks like text. It knows no syntax.
#pragma once

#include "base/stop_flag.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace isl::grammar {

/// Tells whether a file is still the one that was read. All fields are zero if there is no file.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t bytes = 0;
  std::int64_t seconds = 0;  ///< time of its last change
  std::int64_t nanoseconds = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

struct TextFile {
  std::string text;
  std::string trouble;  ///< the reason why there is no text; empty if there is one
  std::string hint;
  bool exists = false;
  FileStamp stamp;
};

/// Never waits for a pipe or a device: those cannot be scenes.
[[nodiscard]] TextFile read_text_file(const std::filesystem::path& file, std::size_t max_bytes);

/// Reads the file `name` in the open folder `folder`; refuses a link, and refuses a file that is not regular without
/// opening it.
[[nodiscard]] TextFile read_text_file_at(int folder, const std::string& name, std::size_t max_bytes);

/// The same for a file that may hold any bytes.
[[nodiscard]] TextFile read_bytes_at(int folder, const std::string& name, std::size_t max_bytes);

/// Waits for what a terminal or another program sends, until `stop` is set; it may be null.
[[nodiscard]] TextFile read_standard_input(std::size_t max_bytes, const StopFlag* stop = nullptr);

[[nodiscard]] FileStamp stamp_of(const std::filesystem::path& file);
/// The same for `name` in an open folder; for a link, the stamp of the link itself.
[[nodiscard]] FileStamp stamp_at(int folder, const std::string& name);

}  // namespace isl::grammar
