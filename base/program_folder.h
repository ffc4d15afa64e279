// The folder of the running program. Its modules and its libraries of scenes are found from there, so that an
// installation may be moved as a whole.
#pragma once

#include <filesystem>
#include <system_error>

namespace isl {

/// The folder of the executable, links resolved; empty, with `error` set, when the system cannot tell it.
[[nodiscard]] inline std::filesystem::path program_folder(std::error_code& error) {
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace isl
