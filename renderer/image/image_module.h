// Finds and loads the image modules, and calls them. The only place that knows of dynamic loading.
#pragma once

#include "renderer/image/decode_abi.h"
#include "renderer/image/image_abi.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isl::render {

/// A file's bytes, or the reason of a failure (lower case, no full stop).
struct EncodedFile {
  std::vector<unsigned char> bytes;
  std::string error;  ///< empty on success
};

/// Encodes by the format's module (isl_png.so, isl_exr.so, else isl_image.so). A module is loaded when it is first
/// needed, from the executable's folder or else from ../lib/isl beside that. May be called from several threads.
[[nodiscard]] EncodedFile encode_by_module(const IslImage& image);

/// A file that its format's module (isl_png.so, else isl_image.so) has opened to decode it.
class OpenPicture {
 public:
  /// `format`: as decode_abi.h has it. The bytes must outlive this object.
  OpenPicture(std::string_view bytes, const char* format);
  ~OpenPicture();
  OpenPicture(const OpenPicture&) = delete;
  OpenPicture& operator=(const OpenPicture&) = delete;

  /// The reason why the file, or its pixels, cannot be read; "" if they can.
  [[nodiscard]] std::string error() const;
  /// Precondition of all below: there is no error.
  [[nodiscard]] const IslPicture& header() const { return picture_; }
  /// Fills height × width × channels values of the header's type; false on failure.
  [[nodiscard]] bool read(void* values);

 private:
  IslImageRead read_ = nullptr;
  IslImageClose close_ = nullptr;
  IslPicture picture_{};
  std::string problem_;  ///< there is no module
};

}  // namespace isl::render
