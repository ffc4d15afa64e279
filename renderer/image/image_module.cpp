#include "renderer/image/image_module.h"

#include "base/program_module.h"

#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace isl::render {
namespace {

/// PNG and EXR have modules of their own, whose libraries load in a millisecond or two. All others use OpenImageIO,
/// which brings 261 libraries and takes a fifth of a second to load.
const char* module_name(std::string_view format) {
  return format == "png" ? "isl_png.so" : format == "exr" ? "isl_exr.so" : "isl_image.so";
}

struct Module {
  IslImageEncode encode = nullptr;
  IslImageRelease release = nullptr;
  std::string error;  ///< the reason why the module could not be loaded
};

Module load(const char* name) {
  ProgramModule loaded = load_program_module(name);
  if (!loaded.error.empty()) return {.error = loaded.error};
  const auto abi = loaded.function<IslImageAbi>("isl_image_abi");
  const auto encode = loaded.function<IslImageEncode>("isl_image_encode");
  const auto release = loaded.function<IslImageRelease>("isl_image_release");
  if (abi == nullptr || encode == nullptr || release == nullptr || abi() != ISL_IMAGE_ABI) {
    loaded.fail_as_foreign();
    return {.error = loaded.error};
  }
  return {encode, release, {}};
}

/// Each module is loaded once, when the first file of its formats is written.
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
