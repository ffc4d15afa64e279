#include "renderer/scene/image_transparency.h"

#include <string_view>

namespace isl::scene {
namespace {

/// A PNG file has transparent pixels only with alpha in its header's type of colour, or with a chunk tRNS before the
/// pixels.
bool may_png_be_transparent(std::string_view bytes) {
  constexpr std::size_t kColourType = 25;  // after the signature, the chunk's head, width, height and depth
  constexpr int kAlpha = 4;
  if (bytes.size() <= kColourType) return true;
  if ((static_cast<unsigned char>(bytes[kColourType]) & kAlpha) != 0) return true;
  return bytes.substr(0, bytes.find("IDAT")).find("tRNS") != std::string_view::npos;
}

/// By its contents, whatever its name: what is no PNG file will be refused anyway.
bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }

bool is_opaque_format(const Image& image) {
  switch (image.type) {
    case ImageType::jpeg:
    case ImageType::ppm:
    case ImageType::pgm:
    case ImageType::hdr:
    case ImageType::function: return true;
    default: return image.bytes->starts_with("\xff\xd8\xff");  // JPEG files begin so
  }
}

}  // namespace

bool may_be_transparent(const Image& image) {
  if (image.once || image.filter_all.value_or(0) != 0 || image.transmit_all.value_or(0) != 0) return true;
  if (!image.filters.empty() || !image.transmits.empty()) return true;
  if (image.type != ImageType::function && !image.bytes) return false;
  if (is_opaque_format(image)) return false;
  return !is_png(*image.bytes) || may_png_be_transparent(*image.bytes);
}

}  // namespace isl::scene
