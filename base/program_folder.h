// Where the running program stands. What belongs to it (its modules, its libraries of scenes) is found from there, so
// that an installation may be moved as a whole.
#pragma once

#include <filesystem>
#include <system_error>

namespace isl {

/// The folder of the executable, links resolved; empty, with `error` set, where the system does not tell.
[[nodiscard]] inline std::filesystem::path program_folder(std::error_code& error) {
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace isl
