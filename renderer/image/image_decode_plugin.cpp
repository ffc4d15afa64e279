// Decodes files of all formats but PNG by OpenImageIO, in the module that encodes them, too. Knows nothing of scenes;
// see decode_abi.h.
#include "renderer/image/decode_entry.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace isl::render {
namespace {

class OiioReader final : public PictureReader {
 public:
  OiioReader(std::span<const unsigned char> bytes, const std::string& format)
      : bytes_(bytes),
        file_(const_cast<unsigned char*>(bytes.data()), bytes.size()),
        input_(OIIO::ImageInput::create(format)),
        is_radiance_(format == "hdr") {
    if (!input_) {
      static_cast<void>(OIIO::geterror());
      throw std::runtime_error("OpenImageIO was built without this format");
    }
    if (!input_->supports("ioproxy")) throw std::runtime_error("OpenImageIO cannot read this format from memory");
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    input_->set_ioproxy(&file_);
    if (!input_->open("picture." + format, spec_, wishes)) throw std::runtime_error(reason("it is not such a file"));
  }

  void describe(IslPicture& header) {
    header.width = spec_.width;
    header.height = spec_.height;
    header.hides_palette = has_palette() ? 1 : 0;
    choose_channels();
    header.channels = static_cast<int>(channels_.size());
    type_ = spec_.format == OIIO::TypeDesc::UINT8    ? OIIO::TypeDesc::UINT8
            : spec_.format == OIIO::TypeDesc::UINT16 ? OIIO::TypeDesc::UINT16
                                                     : OIIO::TypeDesc::FLOAT;
    header.type = type_ == OIIO::TypeDesc::UINT8 ? ISL_UINT8 : type_ == OIIO::TypeDesc::UINT16 ? ISL_UINT16 : ISL_FLOAT;
  }

  /// One row after the other, so that no second picture is in memory.
  void read(void* values) override {
    const std::size_t size = type_.size(), all = static_cast<std::size_t>(spec_.nchannels);
    const auto width = static_cast<std::size_t>(spec_.width);
    auto* to = static_cast<char*>(values);
    if (spec_.tile_width != 0) return read_whole(to);
    std::vector<char> row(width * all * size);
    for (int y = 0; y < spec_.height; ++y) {
      if (!input_->read_scanline(spec_.y + y, 0, type_, row.data())) throw std::runtime_error(reason("it is broken"));
      if (is_radiance_) add_half_steps(row);
      to = pick(row.data(), width, to);
    }
  }

 private:
  /// OpenImageIO gives the colours of palettes, and does not say that there was one, except in TIFF.
  [[nodiscard]] bool has_palette() const {
    const std::string format = input_->format_name();
    const auto byte = [this](std::size_t at) { return at < bytes_.size() ? bytes_[at] : 0; };
    if (format == "targa") return byte(1) == 1;
    if (format == "bmp") return byte(28) <= 8;  // bits of a pixel
    return format == "tiff" && spec_.get_int_attribute("tiff:PhotometricInterpretation") == 3;
  }

  /// Radiance's format cuts off the fractions of colours, which share an exponent; half a step is added for what was
  /// cut off, as Ward's own programs and POV-Ray do, and OpenImageIO does not.
  static void add_half_steps(std::vector<char>& row) {
    constexpr int kBits = 8;  // of a fraction
    std::array<float, 3> colour;
    for (std::size_t at = 0; at + sizeof colour <= row.size(); at += sizeof colour) {
      std::memcpy(&colour, &row[at], sizeof colour);
      const float most = std::max({colour[0], colour[1], colour[2]});
      if (!(most > 0)) continue;
      int exponent = 0;
      static_cast<void>(std::frexp(most, &exponent));
      for (float& channel : colour) channel += std::ldexp(0.5F, exponent - kBits);
      std::memcpy(&row[at], &colour, sizeof colour);
    }
  }

  /// A file of tiles: OpenImageIO puts them together.
  void read_whole(char* to) {
    const std::size_t pixels = static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(spec_.height);
    std::vector<char> all(pixels * static_cast<std::size_t>(spec_.nchannels) * type_.size());
    if (!input_->read_image(0, 0, 0, spec_.nchannels, type_, all.data()))
      throw std::runtime_error(reason("it is broken"));
    static_cast<void>(pick(all.data(), pixels, to));
  }

  /// Copies the chosen channels of a run of pixels; returns where the next go.
  char* pick(const char* from, std::size_t pixels, char* to) const {
    const std::size_t size = type_.size(), stride = size * static_cast<std::size_t>(spec_.nchannels);
    for (std::size_t i = 0; i < pixels; ++i, from += stride) {
      for (const int channel : channels_) {
        std::memcpy(to, from + static_cast<std::size_t>(channel) * size, size);
        to += size;
      }
    }
    return to;
  }

  /// Grey, or red, green, blue, and alpha; files may have others between them.
  void choose_channels() {
    const std::array<const char*, 3> names{"R", "G", "B"};
    for (const char* const name : names) {
      const int channel = spec_.channelindex(name);
      if (channel >= 0) channels_.push_back(channel);
    }
    if (channels_.size() != 3) {
      channels_ = {0};
      if (spec_.nchannels >= 3) channels_ = {0, 1, 2};
    }
    const int alpha = spec_.alpha_channel >= 0 ? spec_.alpha_channel : spec_.channelindex("A");
    if (alpha >= static_cast<int>(channels_.size())) channels_.push_back(alpha);
  }

  [[nodiscard]] std::string reason(const char* otherwise) const {
    const std::string error = input_->geterror();
    return error.empty() ? otherwise : error;
  }

  std::span<const unsigned char> bytes_;
  OIIO::Filesystem::IOMemReader file_;
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
  OIIO::TypeDesc type_;
  std::vector<int> channels_;
  bool is_radiance_;
};

}  // namespace

std::unique_ptr<PictureReader> open_picture(std::span<const unsigned char> bytes, const char* format,
                                            IslPicture& header) {
  auto reader = std::make_unique<OiioReader>(bytes, format);
  reader->describe(header);
  return reader;
}

}  // namespace isl::render
