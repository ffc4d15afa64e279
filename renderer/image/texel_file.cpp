#include "renderer/image/texel_file.h"

#include "renderer/image/gif_file.h"
#include "renderer/image/image_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace isl::render {
namespace {

using scene::ImageType;

struct FormatRow {
  ImageType type;
  std::string_view name;                        ///< as the language has it
  std::array<std::string_view, 3> extensions;   ///< in lower case
  const char* module_name;                      ///< decode_abi.h; null: it cannot be read; unused for GIF
  Transfer transfer;                            ///< of files that do not say it themselves
  std::array<std::string_view, 2> begins = {};  ///< where the module reads others, too: how these files begin
};

/// The meaning of codes was measured in POV-Ray 3.7: those of PPM, PGM and TIFF are values of the working space.
constexpr FormatRow kFormats[] = {
    {ImageType::png, "png", {"png"}, "png", Transfer::srgb},
    {ImageType::jpeg, "jpeg", {"jpg", "jpeg"}, "jpeg", Transfer::srgb},
    {ImageType::gif, "gif", {"gif"}, "", Transfer::srgb},
    {ImageType::tga, "tga", {"tga"}, "targa", Transfer::srgb},
    {ImageType::bmp, "bmp", {"bmp"}, "bmp", Transfer::srgb},
    {ImageType::ppm, "ppm", {"ppm"}, "pnm", Transfer::working, {"P6", "P3"}},
    {ImageType::pgm, "pgm", {"pgm"}, "pnm", Transfer::working, {"P5", "P2"}},
    {ImageType::tiff, "tiff", {"tif", "tiff"}, "tiff", Transfer::working},
    {ImageType::hdr, "hdr", {"hdr"}, "hdr", Transfer::linear},
    {ImageType::exr, "exr", {"exr"}, "openexr", Transfer::linear},
    // OpenImageIO reads Maya's files of that name, but not those of the Amiga, which the language means.
    {ImageType::iff, "iff", {"iff"}, nullptr, Transfer::srgb},
    {ImageType::pot, "pot", {"pot"}, nullptr, Transfer::srgb},
    {ImageType::sys, "sys", {""}, nullptr, Transfer::srgb},
};

std::string extension_of(std::string_view file) {
  const std::size_t dot = file.find_last_of("./\\");
  if (dot == std::string_view::npos || file[dot] != '.') return "";
  std::string extension(file.substr(dot + 1));
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

const FormatRow* format_of(std::string_view file, ImageType type) {
  if (type != ImageType::unnamed) {
    const auto* const row = std::ranges::find(kFormats, type, &FormatRow::type);
    return row == std::end(kFormats) ? nullptr : row;
  }
  const std::string extension = extension_of(file);
  const auto* const row = std::ranges::find_if(kFormats, [&](const FormatRow& format) {
    return !extension.empty() && std::ranges::find(format.extensions, extension) != format.extensions.end();
  });
  return row == std::end(kFormats) ? nullptr : row;
}

std::size_t value_bytes(IslSampleType type) { return type == ISL_UINT8 ? 1 : type == ISL_UINT16 ? 2 : 4; }

Texels described(const IslPicture& picture, const FormatRow& format) {
  Texels texels;
  texels.width = picture.width;
  texels.height = picture.height;
  texels.channels = picture.channels;
  texels.sample = picture.palette_size > 0     ? Texels::Sample::index
                  : picture.type == ISL_UINT8  ? Texels::Sample::bits8
                  : picture.type == ISL_UINT16 ? Texels::Sample::bits16
                                               : Texels::Sample::real;
  for (int i = 0; i < picture.palette_size; ++i) {
    const unsigned char* const colour = picture.palette[i];
    texels.palette.push_back({colour[0], colour[1], colour[2], colour[3]});
  }
  texels.hides_palette = picture.hides_palette != 0;
  texels.transfer = format.transfer;
  texels.is_premultiplied = format.type == ImageType::exr;
  texels.states_transfer = picture.states_transfer != 0;
  if (texels.states_transfer) {
    texels.transfer = picture.transfer == ISL_GAMMA    ? Transfer::power
                      : picture.transfer == ISL_LINEAR ? Transfer::linear
                                                       : Transfer::srgb;
    texels.gamma = picture.gamma;
  }
  return texels;
}

DecodedTexels unreadable(const FormatRow& format, const std::string& error) {
  return {nullptr, fmt::format("it cannot be read as {}: {}", format.name, error)};
}

/// Makes room for the pixels, whose number the header gives, before they are decoded. `scratch` counts what a library
/// takes besides: most hold the whole picture.
DecodedTexels take_memory(std::shared_ptr<Texels> texels, std::size_t bytes_of_value, Charge& scratch,
                          const RunLimits& run) {
  if (texels->width < 1 || texels->height < 1) return {nullptr, "it has no pixels"};
  if (texels->width > kMostTexelsOfSide || texels->height > kMostTexelsOfSide) {
    return {nullptr, fmt::format("it has {}x{} pixels, and at most {} a side can be read", texels->width,
                                 texels->height, kMostTexelsOfSide)};
  }
  const std::size_t size = static_cast<std::size_t>(texels->width) * static_cast<std::size_t>(texels->height) *
                           static_cast<std::size_t>(texels->channels) * bytes_of_value;
  texels->charge = Charge(run.budget);
  if (!texels->charge.grow(size) || !scratch.grow(size)) {
    return {nullptr,
            fmt::format("its {}x{} pixels take more memory than the limit leaves", texels->width, texels->height),
            true};
  }
  texels->values.resize(size);
  return {std::move(texels), ""};
}

DecodedTexels decode_gif(std::string_view bytes, const FormatRow& format, const RunLimits& run) {
  GifFile file({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  if (!file.error().empty()) return unreadable(format, file.error());
  auto texels = std::make_shared<Texels>();
  texels->width = file.width();
  texels->height = file.height();
  texels->channels = 1;
  texels->sample = Texels::Sample::index;
  texels->palette = file.palette();
  texels->transfer = format.transfer;
  Charge scratch(run.budget);
  DecodedTexels result = take_memory(texels, 1, scratch, run);
  if (result.texels && !file.read(texels->values)) return unreadable(format, file.error());
  return result;
}

DecodedTexels decode_by_module(std::string_view bytes, const FormatRow& format, const RunLimits& run) {
  const auto begins_so = [bytes](std::string_view text) { return !text.empty() && bytes.starts_with(text); };
  if (!format.begins[0].empty() && std::ranges::none_of(format.begins, begins_so))
    return unreadable(format, "it does not begin as such a file");
  OpenPicture picture(bytes, format.module_name);
  if (const std::string error = picture.error(); !error.empty()) return unreadable(format, error);
  const IslPicture& header = picture.header();
  if (header.channels < 1 || header.channels > 4) return unreadable(format, "it has no colours");
  const auto texels = std::make_shared<Texels>(described(header, format));
  Charge scratch(run.budget);
  DecodedTexels result = take_memory(texels, value_bytes(header.type), scratch, run);
  if (result.texels && !picture.read(texels->values.data())) return unreadable(format, picture.error());
  return result;
}

}  // namespace

DecodedTexels decode_texels(std::string_view bytes, std::string_view file, ImageType type, const RunLimits& run) {
  const FormatRow* const format = format_of(file, type);
  if (format == nullptr) return {nullptr, "its format is not known: name it before the file, as in `png`"};
  if (format->module_name == nullptr) return {nullptr, fmt::format("the format `{}` cannot be read", format->name)};
  if (format->type == ImageType::gif) return decode_gif(bytes, *format, run);
  return decode_by_module(bytes, *format, run);
}

}  // namespace isl::render
