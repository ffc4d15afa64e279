// The module of all formats except PNG and EXR: it encodes planes as the bytes of a file, by OpenImageIO. No other
// source includes that library. Knows nothing of scenes or rendering; see image_abi.h.
#include "renderer/image/plugin_entry.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace isl::render {
namespace {

OIIO::TypeDesc type_of(IslSampleType type) {
  switch (type) {
    case ISL_UINT8: return OIIO::TypeDesc::UINT8;
    case ISL_UINT16: return OIIO::TypeDesc::UINT16;
    case ISL_FLOAT: return OIIO::TypeDesc::FLOAT;
    case ISL_UINT32:
    case ISL_HALF: break;
  }
  throw std::invalid_argument("found a plane of halfs or 32-bit integers, which only EXR can hold");
}

/// Precondition: all planes have one type.
OIIO::ImageSpec spec_of(const IslImage& image) {
  OIIO::ImageSpec spec(image.width, image.height, image.plane_count, type_of(image.planes[0].type));
  spec.channelnames.clear();
  for (int i = 0; i < image.plane_count; ++i) spec.channelnames.emplace_back(image.planes[i].name);
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
  if (format == "tif") spec.attribute("Compression", "zip");
  for (int i = 0; i < image.text_count; ++i) spec.attribute(image.texts[i].name, image.texts[i].value);
  return spec;
}

/// The values of all planes, pixel by pixel.
std::vector<char> interleaved(const IslImage& image) {
  const std::size_t size = type_of(image.planes[0].type).size();
  const std::size_t pixel_bytes = static_cast<std::size_t>(image.plane_count) * size;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<char> bytes(pixels * pixel_bytes);
  for (int i = 0; i < image.plane_count; ++i) {
    const auto* const values = static_cast<const char*>(image.planes[i].values);
    char* out = bytes.data() + static_cast<std::size_t>(i) * size;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel, out += pixel_bytes)
      std::memcpy(out, values + pixel * size, size);
  }
  return bytes;
}

}  // namespace

std::vector<unsigned char> encode_picture(const IslImage& image) {
  const std::string name = std::string("picture.") + image.format;
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) throw std::runtime_error(OIIO::geterror());
  if (!output->supports("ioproxy")) throw std::runtime_error(name + ": cannot be encoded in memory");
  const OIIO::ImageSpec spec = spec_of(image);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput target(bytes);
  output->set_ioproxy(&target);
  if (!output->open(name, spec)) throw std::runtime_error(output->geterror());
  if (!output->write_image(spec.format, interleaved(image).data())) throw std::runtime_error(output->geterror());
  if (!output->close()) throw std::runtime_error(output->geterror());
  return bytes;
}

}  // namespace isl::render
