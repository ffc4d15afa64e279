// The C interface of image modules that decode (decode_abi.h). No exception leaves it, and neither side frees memory of
// the other.
#include "renderer/image/decode_entry.h"

#include <cstdlib>
#include <cstring>
#include <exception>

namespace {

void fail(IslPicture& picture, const std::exception& problem) {
  std::free(picture.error);
  picture.error = strdup(problem.what());
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void isl_image_open(const unsigned char* bytes, size_t size, const char* format,
                                                           IslPicture* picture) {
  *picture = {};
  try {
    picture->reader = isl::render::open_picture({bytes, size}, format, *picture).release();
  } catch (const std::exception& problem) {
    fail(*picture, problem);
  }
}

__attribute__((visibility("default"))) int isl_image_read(IslPicture* picture, void* values) {
  try {
    static_cast<isl::render::PictureReader*>(picture->reader)->read(values);
    return 1;
  } catch (const std::exception& problem) {
    fail(*picture, problem);
    return 0;
  }
}

__attribute__((visibility("default"))) void isl_image_close(IslPicture* picture) {
  delete static_cast<isl::render::PictureReader*>(picture->reader);
  std::free(picture->error);
  *picture = {};
}
}
