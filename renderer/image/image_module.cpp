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
  // Null in modules that only encode.
  IslImageOpen open = nullptr;
  IslImageRead read = nullptr;
  IslImageClose close = nullptr;
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
  return {encode,
          release,
          loaded.function<IslImageOpen>("isl_image_open"),
          loaded.function<IslImageRead>("isl_image_read"),
          loaded.function<IslImageClose>("isl_image_close"),
          {}};
}

/// Each module is loaded once, when it is first needed.
const Module& module_named(const char* name) {
  static std::mutex mutex;
  static std::map<std::string_view, Module> loaded;
  const std::lock_guard lock(mutex);
  const auto found = loaded.find(name);
  return found != loaded.end() ? found->second : loaded.emplace(name, load(name)).first->second;
}

}  // namespace

EncodedFile encode_by_module(const IslImage& image) {
  const Module& module = module_named(module_name(image.format));
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

OpenPicture::OpenPicture(std::string_view bytes, const char* format) {
  // The module of EXR files only encodes; a picture that is read pays for OpenImageIO once.
  const Module& module = module_named(std::string_view(format) == "png" ? "isl_png.so" : "isl_image.so");
  if (module.open == nullptr || module.read == nullptr || module.close == nullptr) {
    problem_ = module.error.empty() ? "the image module cannot decode" : module.error;
    return;
  }
  read_ = module.read;
  close_ = module.close;
  module.open(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), format, &picture_);
}

OpenPicture::~OpenPicture() {
  if (close_ != nullptr) close_(&picture_);
}

std::string OpenPicture::error() const {
  if (!problem_.empty()) return problem_;
  if (picture_.error != nullptr) return picture_.error;
  return picture_.reader == nullptr ? "the image module ran out of memory" : "";
}

bool OpenPicture::read(void* values) { return read_(&picture_, values) != 0; }

}  // namespace isl::render
