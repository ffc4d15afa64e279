// The PNG module: it encodes planes as the bytes of a PNG file, by libpng, with the image data from png_data.h. Knows
// nothing of scenes or rendering; see image_abi.h.
#include "renderer/image/plugin_entry.h"
#include "renderer/image/png_data.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace isl::render {
namespace {

/// The bytes that libpng writes, and the text of an error. libpng leaves its functions after an error by longjmp, which
/// must not skip a destructor: therefore all objects with destructors live here, outside the function that longjmp
/// leaves.
struct Output {
  std::vector<unsigned char> bytes;
  std::vector<std::vector<unsigned char>> data;  ///< the pixels, compressed
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
  if (!has_room) png_error(png, "out of memory");
}

void on_flush(png_structp) {}

/// tEXt is Latin-1, iTXt is UTF-8. ASCII text is the same in both, and goes into tEXt.
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

/// Writes everything before the pixels.
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
  png_write_info(png, info);
}

/// False if it failed; `output` then has the reason. Nothing in this function has a destructor.
bool write_all(png_structp png, png_infop info, const IslImage& image, Output& output) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &output, on_bytes, on_flush);
  write_header(png, info, image, output);
  for (const std::vector<unsigned char>& piece : output.data) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), piece.data(), piece.size());
  }
  // png_write_end cannot be used: it looks for data that libpng compressed itself.
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  return true;
}

}  // namespace

std::vector<unsigned char> encode_picture(const IslImage& image) {
  if (std::string_view(image.format) != "png" || image.plane_count != (image.alpha_plane < 0 ? 3 : 4) ||
      (image.planes[0].type != ISL_UINT8 && image.planes[0].type != ISL_UINT16)) {
    throw std::invalid_argument("expected 3 or 4 planes of 8 or 16 bits for PNG");
  }
  Output output;
  output.data = png_data(image, std::max(1, image.threads));
  for (int i = 0; i < image.text_count; ++i) output.texts.push_back(text_chunk(image.texts[i]));
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, on_error, on_warning);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png);
  const bool good = info != nullptr && write_all(png, info, image, output);
  png_destroy_write_struct(&png, &info);
  if (!good) throw std::runtime_error(output.error[0] != '\0' ? output.error : "out of memory");
  return std::move(output.bytes);
}

}  // namespace isl::render
