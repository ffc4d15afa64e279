// The C interface of every image module (image_abi.h), around the one function in which modules differ. No exception
// leaves it, and neither side frees memory of the other.
#include "renderer/image/plugin_entry.h"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

extern "C" {

__attribute__((visibility("default"))) int isl_image_abi() { return ISL_IMAGE_ABI; }

__attribute__((visibility("default"))) void isl_image_encode(const IslImage* image, IslEncoded* encoded) {
  *encoded = {};
  try {
    const std::vector<unsigned char> bytes = isl::render::encode_picture(*image);
    encoded->bytes = static_cast<unsigned char*>(std::malloc(bytes.size()));
    if (encoded->bytes == nullptr) throw std::bad_alloc();
    encoded->size = bytes.size();
    std::memcpy(encoded->bytes, bytes.data(), bytes.size());
  } catch (const std::exception& problem) {
    encoded->error = strdup(problem.what());
  }
}

__attribute__((visibility("default"))) void isl_image_release(IslEncoded* encoded) {
  std::free(encoded->bytes);
  std::free(encoded->error);
  *encoded = {};
}
}
