// The program's version; the build passes it from the project's CMakeLists.txt.
#pragma once

namespace isl::cli {

inline constexpr const char* kVersion = ISL_VERSION;

}  // namespace isl::cli
