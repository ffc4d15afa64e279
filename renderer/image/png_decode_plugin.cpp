// Decodes PNG files by libpng, in the PNG module: it tells numbers of palettes and the chunks of gamma, which a reader
// of many formats does not, and is loaded in a millisecond. Knows nothing of scenes; see decode_abi.h.
#include "renderer/image/decode_entry.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

namespace isl::render {
namespace {

/// libpng leaves its functions after an error by longjmp, which must not skip a destructor: the functions that call
/// setjmp have no objects with destructors, and what has to be freed lives in the reader.
class PngReader final : public PictureReader {
 public:
  explicit PngReader(std::span<const unsigned char> bytes) : rest_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() override { png_destroy_read_struct(&png_, &info_, nullptr); }

  void open(IslPicture& header) {
    if (png_sig_cmp(rest_.data(), 0, std::min<std::size_t>(rest_.size(), 8)) != 0 || rest_.size() < 8)
      throw std::runtime_error("it is not a PNG file");
    if (!read_header(header)) fail();
  }
  void read(void* values) override {
    if (!read_rows(static_cast<unsigned char*>(values))) fail();
  }

 private:
  [[noreturn]] void fail() const { throw std::runtime_error(error_[0] != '\0' ? error_ : "out of memory"); }

  static void on_error(png_structp png, png_const_charp message) {
    auto* const self = static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(self->error_, message, sizeof self->error_ - 1);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}
  static void on_bytes(png_structp png, png_bytep to, std::size_t size) {
    auto* const self = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > self->rest_.size()) png_error(png, "the file ends too early");
    std::memcpy(to, self->rest_.data(), size);
    self->rest_ = self->rest_.subspan(size);
  }

  bool read_header(IslPicture& header) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, on_bytes);
    png_read_info(png_, info_);
    header.width = static_cast<int>(png_get_image_width(png_, info_));
    header.height = static_cast<int>(png_get_image_height(png_, info_));
    const int kind = png_get_color_type(png_, info_);
    read_transfer(header);
    if (kind == PNG_COLOR_TYPE_PALETTE) {
      read_palette(header);
      png_set_packing(png_);
    } else {
      if (kind == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png_);
      if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
      png_set_swap(png_);  // 16 bits of the file are big-endian, and those of all machines that we build for are not
    }
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    header.channels = png_get_channels(png_, info_);
    header.type = png_get_bit_depth(png_, info_) == 16 ? ISL_UINT16 : ISL_UINT8;
    return true;
  }

  void read_palette(IslPicture& header) {
    png_colorp colours = nullptr;
    png_get_PLTE(png_, info_, &colours, &header.palette_size);
    png_bytep alphas = nullptr;
    int alpha_count = 0;
    png_get_tRNS(png_, info_, &alphas, &alpha_count, nullptr);
    header.palette_size = std::min(header.palette_size, 256);
    for (int i = 0; i < header.palette_size; ++i) {
      unsigned char* const to = header.palette[i];
      to[0] = colours[i].red;
      to[1] = colours[i].green;
      to[2] = colours[i].blue;
      to[3] = alphas != nullptr && i < alpha_count ? alphas[i] : 255;
    }
  }

  void read_transfer(IslPicture& header) {
    int intent = 0;
    double file_gamma = 0;
    header.transfer = ISL_SRGB;
    if (png_get_sRGB(png_, info_, &intent) != 0) {
      header.states_transfer = 1;
    } else if (png_get_gAMA(png_, info_, &file_gamma) != 0 && file_gamma > 0) {
      header.states_transfer = 1;
      header.transfer = ISL_GAMMA;
      header.gamma = 1 / file_gamma;
    }
  }

  bool read_rows(unsigned char* values) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    const std::size_t row_bytes = png_get_rowbytes(png_, info_);
    const png_uint_32 height = png_get_image_height(png_, info_);
    for (int pass = 0; pass < passes_; ++pass) {
      for (png_uint_32 row = 0; row < height; ++row) png_read_row(png_, values + row * row_bytes, nullptr);
    }
    png_read_end(png_, nullptr);
    return true;
  }

  std::span<const unsigned char> rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  char error_[256] = "";
};

}  // namespace

std::unique_ptr<PictureReader> open_picture(std::span<const unsigned char> bytes, const char* /*format*/,
                                            IslPicture& header) {
  auto reader = std::make_unique<PngReader>(bytes);
  reader->open(header);
  return reader;
}

}  // namespace isl::render
