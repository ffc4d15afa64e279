// The EXR module: planes → the bytes of an OpenEXR file of one part, by OpenEXR. Knows nothing of scenes or rendering;
// see image_abi.h.
#include "renderer/image/plugin_entry.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <half.h>

#include <cstring>
#include <deque>
#include <stdexcept>
#include <string>

namespace isl::render {
namespace {

/// A file in memory. OpenEXR goes back to fill in the table of offsets when it has written the pixels.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("picture.exr") {}

  void write(const char data[], int size) override {
    const auto count = static_cast<std::size_t>(size);
    if (position_ + count > bytes_.size()) bytes_.resize(position_ + count);
    std::memcpy(bytes_.data() + position_, data, count);
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  [[nodiscard]] std::vector<unsigned char> take() { return std::move(bytes_); }

 private:
  std::vector<unsigned char> bytes_;
  std::size_t position_ = 0;
};

Imf::PixelType type_of(IslSampleType type) {
  switch (type) {
    case ISL_UINT32: return Imf::UINT;
    case ISL_HALF: return Imf::HALF;
    case ISL_FLOAT: return Imf::FLOAT;
    case ISL_UINT8:
    case ISL_UINT16: break;
  }
  throw std::invalid_argument("found a plane of 8 or 16 bits, expected 32-bit integers, floats or halfs for EXR");
}

Imf::Header header_of(const IslImage& image) {
  const Imath::Box2i whole({0, 0}, {image.full_width - 1, image.full_height - 1});
  const Imath::Box2i window({image.x, image.y}, {image.x + image.width - 1, image.y + image.height - 1});
  Imf::Header header(whole, window);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert("capDate", Imf::StringAttribute(kFixedDate));
  for (int i = 0; i < image.text_count; ++i) {
    header.insert(image.texts[i].name, Imf::StringAttribute(image.texts[i].value));
  }
  for (int i = 0; i < image.plane_count; ++i) {
    header.channels().insert(image.planes[i].name, Imf::Channel(type_of(image.planes[i].type)));
  }
  return header;
}

/// Describes the pixels of the planes to OpenEXR. Halfs are given as floats, and are converted here.
class Pixels {
 public:
  explicit Pixels(const IslImage& image) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (int i = 0; i < image.plane_count; ++i) {
      const IslPlane& plane = image.planes[i];
      const void* values = plane.values;
      if (plane.type == ISL_HALF) {
        const auto* const floats = static_cast<const float*>(plane.values);
        values = halfs_.emplace_back(floats, floats + count).data();
      }
      const std::size_t size = plane.type == ISL_HALF ? sizeof(half) : sizeof(float);
      // OpenEXR only reads from here, although its type does not say so.
      auto* const bytes = static_cast<char*>(const_cast<void*>(values));
      const Imath::Box2i window({image.x, image.y}, {image.x + image.width - 1, image.y + image.height - 1});
      frame_.insert(plane.name, Imf::Slice::Make(type_of(plane.type), bytes, window, size,
                                                 size * static_cast<std::size_t>(image.width)));
    }
  }

  [[nodiscard]] const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  std::deque<std::vector<half>> halfs_;
  Imf::FrameBuffer frame_;
};

}  // namespace

std::vector<unsigned char> encode_picture(const IslImage& image) {
  if (std::string(image.format) != "exr")
    throw std::invalid_argument("found another format than exr in the EXR module");
  const Imf::Header header = header_of(image);
  const Pixels pixels(image);
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(pixels.frame());
    file.writePixels(image.height);
  }  // the destructor of `file` writes the table of offsets
  return stream.take();
}

}  // namespace isl::render
