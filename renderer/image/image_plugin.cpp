// The image module: planes → the bytes of a file, by OpenImageIO. The only source that includes it, and the only
// content of the shared object `isl_image`. Knows nothing of scenes or rendering; see image_abi.h.
#include "renderer/image/image_abi.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <half.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// Written into every file, for formats that would otherwise note the time of writing: the same picture is the same
/// bytes.
constexpr const char* kFixedDate = "1970:01:01 00:00:00";

OIIO::TypeDesc type_of(IslSampleType type) {
  switch (type) {
    case ISL_UINT8: return OIIO::TypeDesc::UINT8;
    case ISL_UINT16: return OIIO::TypeDesc::UINT16;
    case ISL_UINT32: return OIIO::TypeDesc::UINT32;
    case ISL_HALF: return OIIO::TypeDesc::HALF;
    case ISL_FLOAT: return OIIO::TypeDesc::FLOAT;
  }
  throw std::invalid_argument("unknown type of samples");
}

OIIO::ImageSpec spec_of(const IslImage& image) {
  OIIO::ImageSpec spec(image.width, image.height, image.plane_count, type_of(image.planes[0].type));
  spec.channelnames.clear();
  for (int i = 0; i < image.plane_count; ++i) {
    spec.channelnames.emplace_back(image.planes[i].name);
    spec.channelformats.push_back(type_of(image.planes[i].type));
  }
  spec.x = image.x;
  spec.y = image.y;
  spec.full_width = image.full_width;
  spec.full_height = image.full_height;
  spec.alpha_channel = image.alpha_plane;
  if (image.is_srgb != 0 && image.alpha_plane >= 0) spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("DateTime", kFixedDate);
  const std::string format = image.format;
  // Naming the colour space makes OpenImageIO 2.4 add an Exif directory to TIFF, and in memory it then leaves the
  // file's header pointing there instead of to the picture. Integer TIFF is taken for sRGB anyway.
  if (format != "tif") spec.attribute("oiio:ColorSpace", image.is_srgb != 0 ? "sRGB" : "Linear");
  if (format == "jpg") spec.attribute("Compression", "jpeg:95");
  if (format == "exr" || format == "tif") spec.attribute("Compression", "zip");
  for (int i = 0; i < image.text_count; ++i) spec.attribute(image.texts[i].name, image.texts[i].value);
  return spec;
}

/// All planes, pixel by pixel, each channel in the file's own type.
std::vector<char> interleaved(const IslImage& image) {
  std::size_t pixel_bytes = 0;
  for (int i = 0; i < image.plane_count; ++i) pixel_bytes += type_of(image.planes[i].type).size();
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<char> bytes(pixels * pixel_bytes);
  std::size_t offset = 0;
  for (int i = 0; i < image.plane_count; ++i) {
    const IslPlane& plane = image.planes[i];
    const std::size_t size = type_of(plane.type).size();
    char* out = bytes.data() + offset;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel, out += pixel_bytes) {
      if (plane.type == ISL_HALF) {
        const half value(static_cast<const float*>(plane.values)[pixel]);
        std::memcpy(out, &value, size);
      } else {
        std::memcpy(out, static_cast<const char*>(plane.values) + pixel * size, size);
      }
    }
    offset += size;
  }
  return bytes;
}

std::vector<unsigned char> encode(const IslImage& image) {
  const std::string name = std::string("picture.") + image.format;
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) throw std::runtime_error(OIIO::geterror());
  if (!output->supports("ioproxy")) throw std::runtime_error(name + ": cannot be encoded in memory");
  OIIO::ImageSpec spec = spec_of(image);
  const bool mixed = output->supports("channelformats");
  if (!mixed) spec.channelformats.clear();
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput target(bytes);
  output->set_ioproxy(&target);
  if (!output->open(name, spec)) throw std::runtime_error(output->geterror());
  const std::vector<char> pixels = interleaved(image);
  // UNKNOWN: the pixels are in the file's own types already, channel by channel.
  if (!output->write_image(mixed ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : spec.format, pixels.data())) {
    throw std::runtime_error(output->geterror());
  }
  if (!output->close()) throw std::runtime_error(output->geterror());
  return bytes;
}

void* copied(const void* from, std::size_t size) {
  void* to = std::malloc(size);
  if (to == nullptr) throw std::bad_alloc();
  return std::memcpy(to, from, size);
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int isl_image_abi() { return ISL_IMAGE_ABI; }

__attribute__((visibility("default"))) void isl_image_encode(const IslImage* image, IslEncoded* encoded) {
  *encoded = {};
  try {
    const std::vector<unsigned char> bytes = encode(*image);
    encoded->bytes = static_cast<unsigned char*>(copied(bytes.data(), bytes.size()));
    encoded->size = bytes.size();
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
