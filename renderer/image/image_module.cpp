#include "renderer/image/image_module.h"

#include "base/program_folder.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <string_view>
#include <system_error>

namespace isl::render {
namespace {

namespace fs = std::filesystem;

/// PNG and EXR have modules of their own, whose libraries load in a millisecond or two; OpenImageIO, for all others,
/// brings 261 of them and takes a fifth of a second.
const char* module_name(std::string_view format) {
  return format == "png" ? "isl_png.so" : format == "exr" ? "isl_exr.so" : "isl_image.so";
}

struct Module {
  IslImageEncode encode = nullptr;
  IslImageRelease release = nullptr;
  std::string error;  ///< why there is none
};

/// Where the module is, or an empty path.
fs::path find_module(const char* name, const fs::path& executable_folder) {
  std::error_code ignored;
  for (const fs::path& folder : {executable_folder, executable_folder / ".." / "lib" / "isl"}) {
    if (fs::exists(folder / name, ignored)) return folder / name;
  }
  return {};
}

std::string last_loader_error() {
  const char* error = dlerror();
  return error != nullptr ? error : "unknown reason";
}

Module load(const char* name) {
  Module module;
  std::error_code problem;
  const fs::path folder = program_folder(problem);
  if (problem) {
    module.error = fmt::format("cannot find where the program is installed: {}", problem.message());
    return module;
  }
  const fs::path path = find_module(name, folder);
  if (path.empty()) {
    module.error =
        fmt::format("cannot find the image module {} in {} or in ../lib/isl from there", name, folder.string());
    return module;
  }
  // Never closed: libraries keep threads and statics that outlive any one picture.
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    module.error = fmt::format("cannot load the image module: {}", last_loader_error());
    return module;
  }
  const auto abi = reinterpret_cast<IslImageAbi>(dlsym(handle, "isl_image_abi"));
  const auto encode = reinterpret_cast<IslImageEncode>(dlsym(handle, "isl_image_encode"));
  const auto release = reinterpret_cast<IslImageRelease>(dlsym(handle, "isl_image_release"));
  if (abi == nullptr || encode == nullptr || release == nullptr || abi() != ISL_IMAGE_ABI) {
    module.error = fmt::format("the image module {} belongs to another version of the program", path.string());
    return module;
  }
  module.encode = encode;
  module.release = release;
  return module;
}

/// Each is loaded once, when the first of its formats is written.
const Module& module_of(std::string_view format) {
  const char* const name = module_name(format);
  static std::mutex mutex;
  static std::map<std::string_view, Module> loaded;
  const std::lock_guard lock(mutex);
  const auto found = loaded.find(name);
  return found != loaded.end() ? found->second : loaded.emplace(name, load(name)).first->second;
}

}  // namespace

EncodedFile encode_by_module(const IslImage& image) {
  const Module& module = module_of(image.format);
  EncodedFile file;
  if (module.encode == nullptr) {
    file.error = module.error;
    return file;
  }
  IslEncoded encoded{};
  module.encode(&image, &encoded);
  if (encoded.bytes != nullptr) {
    file.bytes.assign(encoded.bytes, encoded.bytes + encoded.size);
  } else {
    file.error = encoded.error != nullptr ? encoded.error : "the image module ran out of memory";
  }
  module.release(&encoded);
  return file;
}

}  // namespace isl::render
