#include "tests/renderer/image/oiio_reference.h"

#include "renderer/image/transfer.h"

#include <OpenImageIO/filesystem.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <stdexcept>

namespace isl::render::test {
namespace {

using OIIO::TypeDesc;

/// A channel: its name, its type in the file, and its value at a pixel in a type that converts to every type used here.
struct Channel {
  std::string name;
  TypeDesc type;
  std::function<double(std::size_t)> value;
};

std::vector<Channel> exr_channels(const Image& image, TypeDesc colour) {
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < (image.has_alpha ? 4 : 3); ++i) {
    channels.push_back(
        {std::string(1, "RGBA"[i]), colour, [&image, i](std::size_t p) { return image.rgba[4 * p + i]; }});
  }
  for (const Layer& layer : image.layers) {
    const TypeDesc type = layer.aov->value == AovValue::whole ? TypeDesc::UINT32 : TypeDesc::FLOAT;
    for (std::size_t i = 0; i < layer.aov->channels.size(); ++i) {
      channels.push_back({fmt::format("{}.{}", layer.aov->name, layer.aov->channels[i]), type,
                          [&layer, i](std::size_t pixel) { return layer.at(pixel, i); }});
    }
  }
  return channels;
}

std::vector<Channel> png_channels(const Image& image, TypeDesc type) {
  const double most = type == TypeDesc::UINT8 ? 255 : 65535;
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < (image.has_alpha ? 4 : 3); ++i) {
    channels.push_back({std::string(1, "RGBA"[i]), type, [&image, i, most](std::size_t pixel) {
                          const double* const rgba = &image.rgba[4 * pixel];
                          if (i == 3) return std::floor(std::clamp(rgba[3], 0.0, 1.0) * most + 0.5);
                          const double share = image.has_alpha && rgba[3] > 0 ? rgba[3] : 1;
                          return std::floor(display_from_linear(rgba[i] / share) * most + 0.5);
                        }});
  }
  return channels;
}

template <class T>
void append(std::vector<unsigned char>& bytes, T value) {
  const auto* const begin = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof value);
}

std::vector<unsigned char> interleaved(const std::vector<Channel>& channels, std::size_t pixels) {
  std::vector<unsigned char> bytes;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (const Channel& channel : channels) {
      const double value = channel.value(pixel);
      if (channel.type == TypeDesc::UINT8) append(bytes, static_cast<std::uint8_t>(value));
      if (channel.type == TypeDesc::UINT16) append(bytes, static_cast<std::uint16_t>(value));
      if (channel.type == TypeDesc::UINT32) append(bytes, static_cast<std::uint32_t>(value));
      if (channel.type == TypeDesc::HALF) append(bytes, half(static_cast<float>(value)));
      if (channel.type == TypeDesc::FLOAT) append(bytes, static_cast<float>(value));
    }
  }
  return bytes;
}

OIIO::ImageSpec spec_of(const Image& image, const std::vector<Channel>& channels, bool is_exr) {
  OIIO::ImageSpec spec(image.window.width(), image.window.height(), static_cast<int>(channels.size()),
                       channels[0].type);
  spec.channelnames.clear();
  for (const Channel& channel : channels) {
    spec.channelnames.push_back(channel.name);
    if (is_exr) spec.channelformats.push_back(channel.type);
  }
  spec.x = image.window.x0;
  spec.y = image.window.y0;
  spec.full_width = image.full_width;
  spec.full_height = image.full_height;
  spec.alpha_channel = image.has_alpha ? 3 : -1;
  if (!is_exr && image.has_alpha) spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  spec.attribute("oiio:ColorSpace", is_exr ? "Linear" : "sRGB");
  if (is_exr) spec.attribute("Compression", "zip");
  return spec;
}

}  // namespace

std::vector<unsigned char> written_by_oiio(const Image& image, const std::string& format,
                                           const ImageFileOptions& options) {
  const bool is_exr = format == "exr";
  const std::vector<Channel> channels =
      is_exr ? exr_channels(image, options.exr_float ? TypeDesc::FLOAT : TypeDesc::HALF)
             : png_channels(image, options.bits == 8 ? TypeDesc::UINT8 : TypeDesc::UINT16);
  OIIO::ImageSpec spec = spec_of(image, channels, is_exr);
  for (const auto& [name, value] : options.metadata) spec.attribute(name, value);
  const auto output = OIIO::ImageOutput::create("picture." + format);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput target(bytes);
  if (!output || !output->set_ioproxy(&target) || !output->open("picture." + format, spec) ||
      !output->write_image(is_exr ? TypeDesc(TypeDesc::UNKNOWN) : spec.format,
                           interleaved(channels, image.window.area()).data()) ||
      !output->close()) {
    throw std::runtime_error(output ? output->geterror() : OIIO::geterror());
  }
  return bytes;
}

FileContent read_by_oiio(const std::vector<unsigned char>& bytes, const std::string& format) {
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  const auto input = OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open("picture." + format, spec, config)) {
    throw std::runtime_error(input ? input->geterror() : OIIO::geterror());
  }
  FileContent content;
  content.attributes = {fmt::format("size {}x{}", spec.width, spec.height), fmt::format("at {},{}", spec.x, spec.y),
                        fmt::format("whole {}x{}", spec.full_width, spec.full_height),
                        fmt::format("alpha channel {}", spec.alpha_channel)};
  for (int i = 0; i < spec.nchannels; ++i) {
    content.attributes.push_back(
        fmt::format("channel {} {} {}", i, spec.channelnames[i], spec.channelformat(i).c_str()));
  }
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    content.attributes.push_back(
        fmt::format("{}: {} = {}", value.name().string(), value.type().c_str(), value.get_string()));
  }
  std::sort(content.attributes.begin() + 4 + spec.nchannels, content.attributes.end());
  content.pixels.resize(spec.image_bytes(true));
  if (!input->read_image(0, 0, 0, spec.nchannels, TypeDesc::UNKNOWN, content.pixels.data())) {
    throw std::runtime_error(input->geterror());
  }
  return content;
}

}  // namespace isl::render::test
