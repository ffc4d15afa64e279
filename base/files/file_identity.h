// The identity of a file: one for all its names, with `..`, symbolic links and hard links. Inputs and outputs of a run
// are compared by it (file_register.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace isl {

struct FileIdentity {
  std::filesystem::path path;  ///< canonical_path(); empty for a file that has no name, such as a redirected stream
  std::uint64_t device = 0, inode = 0;  ///< both 0 while no file has this name
  [[nodiscard]] bool exists() const { return inode != 0; }
};

/// The absolute path without links, `.` and `..`. The file itself need not exist: a link that leads nowhere yet is
/// followed, too, because writing would follow it.
[[nodiscard]] std::filesystem::path canonical_path(const std::filesystem::path& file);

[[nodiscard]] FileIdentity identity_of(const std::filesystem::path& file);

/// The regular file that a descriptor stands for; nothing for a terminal, a pipe, a device or a closed descriptor.
[[nodiscard]] std::optional<FileIdentity> identity_of_stream(int descriptor);

}  // namespace isl
