// Shared libraries that belong to the program and are loaded when they are first needed, so that nobody waits for a
// library that they do not use. The only place that knows of dynamic loading.
#pragma once

#include "base/program_folder.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace isl {

/// A loaded module, or the reason why it could not be loaded (lower case, no full stop). It is never unloaded:
/// libraries keep threads and static objects that outlive each use.
struct ProgramModule {
  void* handle = nullptr;
  std::filesystem::path path;
  std::string error;  ///< empty on success

  /// The function of this name, or null.
  template <class Function>
  [[nodiscard]] Function function(const char* name) const {
    return reinterpret_cast<Function>(dlsym(handle, name));
  }

  void fail_as_foreign() {
    error = fmt::format("{} belongs to another version of the program: build or install both anew", path.string());
  }
};

/// Loads `file_name` from the program's folder, or else from ../lib/isl beside it.
[[nodiscard]] inline ProgramModule load_program_module(const char* file_name) {
  namespace fs = std::filesystem;
  ProgramModule module;
  std::error_code problem;
  const fs::path program = program_folder(problem);
  if (problem) {
    module.error = fmt::format("cannot find the folder of the program: {}", problem.message());
    return module;
  }
  for (const fs::path& folder : {program, program / ".." / "lib" / "isl"}) {
    std::error_code ignored;
    if (!fs::exists(folder / file_name, ignored)) continue;
    module.path = folder / file_name;
    break;
  }
  if (module.path.empty()) {
    module.error = fmt::format("cannot find {} in {}, nor in ../lib/isl from there", file_name, program.string());
    return module;
  }
  module.handle = dlopen(module.path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module.handle == nullptr) {
    const char* const reason = dlerror();
    module.error = fmt::format("cannot load {}: {}", file_name, reason != nullptr ? reason : "unknown reason");
  }
  return module;
}

}  // namespace isl
