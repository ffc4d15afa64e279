// Writes and reads pictures by OpenImageIO alone, for comparison with our PNG and EXR files.
#pragma once

#include "renderer/image/image_file.h"

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace isl::render::test {

/// The file that OpenImageIO writes for the picture; `format` is png or exr.
[[nodiscard]] std::vector<unsigned char> written_by_oiio(const Image& image, const std::string& format,
                                                         const ImageFileOptions& options);

/// Everything that OpenImageIO finds in a file.
struct FileContent {
  std::vector<std::string> attributes;  ///< "name: type = value", sorted; includes the size, the position and the
                                        ///< channels
  std::vector<unsigned char> pixels;    ///< in the file's own types, channels side by side
};

/// The content of a file. Throws a std::runtime_error if the bytes are not a file of the format.
[[nodiscard]] FileContent read_by_oiio(const std::vector<unsigned char>& bytes, const std::string& format);

}  // namespace isl::render::test
