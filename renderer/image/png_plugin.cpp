// The PNG module: planes → the bytes of a PNG file, by libpng. Knows nothing of scenes or rendering; see image_abi.h.
//
// Filters and level, measured on rendered pictures of 0.8 to 1 million pixels, 8 and 16 bits: choosing between `sub`
// and `up` row by row gives files as small as choosing among all five filters (`paeth` and `average` hardly ever win on
// pictures without grain) and takes half the time of the choice. zlib's level 4, its first with lazy matching, takes a
// third to two thirds of the time of level 6; files grow by 1 to 8 %. libpng itself would take the strategy for
// filtered data, which looks for no short repetitions and makes these files a tenth larger.
#include "renderer/image/plugin_entry.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace isl::render {
namespace {

constexpr int kCompressionLevel = 4;
constexpr int kStrategy = Z_DEFAULT_STRATEGY;
constexpr int kFilters = PNG_FILTER_SUB | PNG_FILTER_UP;
constexpr std::size_t kCompressionBuffer = std::size_t{1} << 16;  ///< largest chunk of compressed data

/// Where libpng writes to, and what went wrong. libpng's own way out of an error is longjmp, which must not pass by an
/// object with a destructor: all such objects live here, outside of the function that it leaves.
struct Output {
  std::vector<unsigned char> bytes;
  std::vector<unsigned char> row;
  std::vector<png_text> texts;
  char error[256] = "";
};

void on_error(png_structp png, png_const_charp message) {
  auto* const output = static_cast<Output*>(png_get_error_ptr(png));
  std::strncpy(output->error, message, sizeof output->error - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_bytes(png_structp png, png_bytep bytes, std::size_t size) {
  std::vector<unsigned char>& all = static_cast<Output*>(png_get_io_ptr(png))->bytes;
  bool has_room = true;
  try {
    all.insert(all.end(), bytes, bytes + size);
  } catch (const std::bad_alloc&) {
    has_room = false;
  }
  if (!has_room) png_error(png, "there is no memory left");
}

void on_flush(png_structp) {}

/// tEXt is Latin-1, iTXt is UTF-8; a text without either's special characters is the same in both.
png_text text_chunk(const IslText& text) {
  const std::string_view value = text.value;
  const bool is_ascii =
      std::all_of(value.begin(), value.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
  png_text chunk{};
  chunk.compression = is_ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  chunk.key = const_cast<char*>(text.name);  // libpng copies it
  chunk.text = const_cast<char*>(text.value);
  (is_ascii ? chunk.text_length : chunk.itxt_length) = value.size();
  return chunk;
}

/// One row of all planes, channel beside channel, in PNG's order of bytes.
void interleave(const IslImage& image, std::size_t y, std::vector<unsigned char>& row) {
  const auto width = static_cast<std::size_t>(image.width), channels = static_cast<std::size_t>(image.plane_count);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    if (image.planes[0].type == ISL_UINT8) {
      const auto* const values = static_cast<const unsigned char*>(image.planes[channel].values) + y * width;
      for (std::size_t x = 0; x < width; ++x) row[x * channels + channel] = values[x];
    } else {
      const auto* const values = static_cast<const unsigned short*>(image.planes[channel].values) + y * width;
      for (std::size_t x = 0; x < width; ++x) {
        unsigned char* const at = &row[2 * (x * channels + channel)];
        at[0] = static_cast<unsigned char>(values[x] >> 8);
        at[1] = static_cast<unsigned char>(values[x] & 0xFF);
      }
    }
  }
}

/// Everything before the pixels.
void write_header(png_structp png, png_infop info, const IslImage& image, const Output& output) {
  const int bits = image.planes[0].type == ISL_UINT8 ? 8 : 16;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), bits,
               image.alpha_plane < 0 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  if (image.x != 0 || image.y != 0) png_set_oFFs(png, info, image.x, image.y, PNG_OFFSET_PIXEL);
  const png_time fixed_date{1970, 1, 1, 0, 0, 0};
  png_set_tIME(png, info, &fixed_date);
  png_set_text(png, info, output.texts.data(), static_cast<int>(output.texts.size()));
  png_set_compression_level(png, kCompressionLevel);
  png_set_compression_strategy(png, kStrategy);
  png_set_compression_buffer_size(png, kCompressionBuffer);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, kFilters);
  png_write_info(png, info);
}

/// False: it failed, and `output` says why. Nothing in here has a destructor.
bool write_all(png_structp png, png_infop info, const IslImage& image, Output& output) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &output, on_bytes, on_flush);
  write_header(png, info, image, output);
  for (int y = 0; y < image.height; ++y) {
    interleave(image, static_cast<std::size_t>(y), output.row);
    png_write_row(png, output.row.data());
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::vector<unsigned char> encode_picture(const IslImage& image) {
  if (std::string_view(image.format) != "png" || image.plane_count != (image.alpha_plane < 0 ? 3 : 4) ||
      (image.planes[0].type != ISL_UINT8 && image.planes[0].type != ISL_UINT16)) {
    throw std::invalid_argument("no picture for PNG: it holds 3 or 4 planes of 8 or 16 bits");
  }
  Output output;
  const std::size_t value_bytes = image.planes[0].type == ISL_UINT8 ? 1 : 2;
  output.row.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.plane_count) * value_bytes);
  for (int i = 0; i < image.text_count; ++i) output.texts.push_back(text_chunk(image.texts[i]));
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, on_error, on_warning);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png);
  const bool good = info != nullptr && write_all(png, info, image, output);
  png_destroy_write_struct(&png, &info);
  if (!good) throw std::runtime_error(output.error[0] != '\0' ? output.error : "there is no memory left");
  return std::move(output.bytes);
}

}  // namespace isl::render
