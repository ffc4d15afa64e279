// Image files that scenes name: what is decoded of each format, and what is said of files that are broken, huge, or of
// another format than the one that is named. Nothing but a message may come of any bytes.
#include "renderer/image/texel_file.h"

#include "base/budget.h"
#include "renderer/image/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <random>
#include <string>

namespace isl::render::test {
namespace {

using scene::ImageType;
using testing::HasSubstr;

/// 3x2 numbers of a palette of four colours, 0 1 2 above 3 3 0; colour 1 is transparent, and has the same code as
/// colour 3. The second file has the same content.
constexpr std::string_view kPalettePng(
    "\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHDR\x00\x00\x00\x03\x00\x00\x00\x02\x02\x03\x00\x00\x00\xe0\x1a\x8e\x89"
    "\x00\x00\x00\x0cPLTE\xff\x00\x00\x00\xff\x00\x00\x00\xff\x00\xff\x00\x68\x9a\xbb\x96"
    "\x00\x00\x00\x02tRNS\xff\x00\xe5\xb7\x30\x4a"
    "\x00\x00\x00\x0cIDAT\x78\x9c\x63\x90\x60\xf8\x00\x00\x01\x3c\x01\x09\x39\xc2\xa9\xaa"
    "\x00\x00\x00\x00IEND\xae\x42\x60\x82",
    107);
constexpr std::string_view kPaletteGif(
    "GIF89a\x03\x00\x02\x00\x81\x00\x00\xff\x00\x00\x00\xff\x00\x00\x00\xff\x00\xff\x00\x21\xf9\x04\x01\x00\x00\x01\x00"
    "\x2c\x00\x00\x00\x00\x03\x00\x02\x00\x00\x08\x09\x00\x01\x04\x10\x30\x60\x00\x80\x80\x00\x3b",
    56);

std::string png_chunk(const std::string& body) {
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
  };
  const auto crc = crc32(0, reinterpret_cast<const unsigned char*>(body.data()), static_cast<unsigned>(body.size()));
  return word(body.size() - 4) + body + word(crc);
}

/// The signature and the header of a grey PNG file.
std::string png_header(std::uint32_t side) {
  std::string size;
  for (int shift = 24; shift >= 0; shift -= 8) size += static_cast<char>(side >> shift);
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR" + size + size + std::string("\x08\x00\x00\x00\x00", 5));
}

/// 2x1 pixels: red, and a half green.
std::string encoded(const char* format) {
  Image image;
  image.full_width = 2;
  image.full_height = 1;
  image.window = {0, 0, 2, 1};
  image.rgba = {1, 0, 0, 1, 0, 0.5, 0, 1};
  const EncodedFile file = encode_image(image, format, {});
  EXPECT_EQ(file.error, "");
  return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

DecodedTexels decode(std::string_view bytes, ImageType type, const RunLimits& run = {}) {
  return decode_texels(bytes, "picture", type, run);
}

int number_at(const Texels& texels, std::size_t i) { return std::to_integer<int>(texels.values.at(i)); }

template <class Value>
Value value_at(const Texels& texels, std::size_t i) {
  Value value;
  std::memcpy(&value, &texels.values.at(i * sizeof value), sizeof value);
  return value;
}

TEST(TexelFile, palettes_keep_the_numbers_of_their_colours) {
  for (const auto& [bytes, type] : {std::pair(kPalettePng, ImageType::png), std::pair(kPaletteGif, ImageType::gif)}) {
    const DecodedTexels decoded = decode(bytes, type);
    ASSERT_TRUE(decoded.texels) << decoded.problem;
    const Texels& texels = *decoded.texels;
    EXPECT_EQ(texels.sample, Texels::Sample::index);
    ASSERT_EQ(texels.values.size(), 6u);
    constexpr std::array<int, 6> kNumbers{0, 1, 2, 3, 3, 0};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(number_at(texels, i), kNumbers[i]) << i;
    ASSERT_EQ(texels.palette.size(), 4u);
    EXPECT_EQ(texels.palette[1], (Texels::PaletteColour{0, 255, 0, 0}));
    EXPECT_EQ(texels.palette[3], (Texels::PaletteColour{0, 255, 0, 255}));
  }
}

TEST(TexelFile, interlaced_gif_has_its_rows_in_order) {
  // Nine rows of one pixel, numbered from the top.
  const std::string palette(48, '\x33');
  const std::string bytes =
      std::string("GIF87a\x01\x00\x09\x00\x83\x00\x00", 13) + palette +
      std::string("\x2c\x00\x00\x00\x00\x01\x00\x09\x00\x40\x04\x07\x10\x20\x22\x4c\x18\xe5\x44\x00\x3b", 21);
  const DecodedTexels decoded = decode(bytes, ImageType::gif);
  ASSERT_TRUE(decoded.texels) << decoded.problem;
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(number_at(*decoded.texels, i), static_cast<int>(i));
}

TEST(TexelFile, png_keeps_16_bits_and_what_its_codes_mean) {
  const DecodedTexels decoded = decode(encoded("png"), ImageType::png);
  ASSERT_TRUE(decoded.texels) << decoded.problem;
  EXPECT_EQ(decoded.texels->sample, Texels::Sample::bits16);
  EXPECT_EQ(value_at<std::uint16_t>(*decoded.texels, 0), 65535);
  // srgb_from_linear(0.5) = 0.735357.
  EXPECT_EQ(value_at<std::uint16_t>(*decoded.texels, 4), std::lround(0.7353569830524495 * 65535));
  EXPECT_EQ(decoded.texels->transfer, Transfer::srgb);
  EXPECT_TRUE(decoded.texels->states_transfer);
}

TEST(TexelFile, png_without_a_statement_is_srgb_and_gama_is_its_power) {
  std::string plain = png_header(1);
  const std::string rest =
      png_chunk("IDAT" + std::string("\x78\x9c\x63\x68\x00\x00\x00\x82\x00\x81", 10)) + png_chunk("IEND");
  const DecodedTexels decoded = decode(plain + rest, ImageType::png);
  ASSERT_TRUE(decoded.texels) << decoded.problem;
  EXPECT_EQ(number_at(*decoded.texels, 0), 128);
  EXPECT_EQ(decoded.texels->transfer, Transfer::srgb);
  EXPECT_FALSE(decoded.texels->states_transfer);
  // 50000 / 100000: light is the square of the code.
  const DecodedTexels power = decode(plain + png_chunk(std::string("gAMA\x00\x00\xc3\x50", 8)) + rest, ImageType::png);
  ASSERT_TRUE(power.texels) << power.problem;
  EXPECT_EQ(power.texels->transfer, Transfer::power);
  EXPECT_NEAR(power.texels->gamma, 2, 1e-9);
}

TEST(TexelFile, other_formats_are_read) {
  struct Row {
    const char* format;
    ImageType type;
    Transfer transfer;
  };
  for (const Row& row : {Row{"jpg", ImageType::jpeg, Transfer::srgb}, Row{"tif", ImageType::tiff, Transfer::working},
                         Row{"ppm", ImageType::ppm, Transfer::working}, Row{"hdr", ImageType::hdr, Transfer::linear},
                         Row{"exr", ImageType::exr, Transfer::linear}}) {
    const DecodedTexels decoded = decode(encoded(row.format), row.type);
    ASSERT_TRUE(decoded.texels) << row.format << decoded.problem;
    EXPECT_EQ(decoded.texels->width, 2) << row.format;
    EXPECT_EQ(decoded.texels->height, 1) << row.format;
    EXPECT_EQ(decoded.texels->channels, 3) << row.format;
    EXPECT_EQ(decoded.texels->transfer, row.transfer) << row.format;
  }
  EXPECT_FLOAT_EQ(value_at<float>(*decode(encoded("exr"), ImageType::exr).texels, 4), 0.5F);
  EXPECT_EQ(number_at(*decode("P5 2 1 255\n\x07\x80", ImageType::pgm).texels, 1), 128);
}

TEST(TexelFile, the_named_format_alone_is_tried) {
  EXPECT_THAT(decode(encoded("png"), ImageType::jpeg).problem, HasSubstr("it cannot be read as jpeg: "));
  EXPECT_THAT(decode(encoded("jpg"), ImageType::png).problem, HasSubstr("it cannot be read as png: it is not a PNG"));
  EXPECT_THAT(decode(encoded("png"), ImageType::gif).problem, HasSubstr("it cannot be read as gif: it is not a GIF"));
  EXPECT_THAT(decode("P5 1 1 255\n\x07", ImageType::ppm).problem, HasSubstr("it does not begin as such a file"));
  EXPECT_THAT(decode("P6 1 1 255\n\x07\x07\x07", ImageType::pgm).problem, HasSubstr("cannot be read as pgm"));
  const std::string png = encoded("png");
  EXPECT_TRUE(decode_texels(png, "A.PNG", ImageType::unnamed, {}).texels);
  EXPECT_FALSE(decode_texels(png, "a.jpg", ImageType::unnamed, {}).texels);
  EXPECT_THAT(decode_texels(png, "a.dat", ImageType::unnamed, {}).problem, HasSubstr("its format is not known"));
  EXPECT_THAT(decode(png, ImageType::iff).problem, HasSubstr("the format `iff` cannot be read"));
}

TEST(TexelFile, text_and_nothing_are_no_images) {
  for (const std::string_view bytes : {std::string_view(), std::string_view("sphere { 0, 1 }\n")}) {
    for (int type = static_cast<int>(ImageType::bmp); type < static_cast<int>(ImageType::function); ++type) {
      const DecodedTexels decoded = decode(bytes, static_cast<ImageType>(type));
      EXPECT_FALSE(decoded.texels) << type;
      EXPECT_NE(decoded.problem, "") << type;
    }
  }
}

TEST(TexelFile, files_that_end_too_early_are_told) {
  for (const auto& [bytes, type] : {std::pair(kPalettePng, ImageType::png), std::pair(kPaletteGif, ImageType::gif)}) {
    // The last byte of the GIF file only says that no picture follows.
    const std::size_t needed = type == ImageType::gif ? bytes.size() - 3 : bytes.size();
    for (std::size_t size = 0; size < needed; ++size)
      EXPECT_FALSE(decode(bytes.substr(0, size), type).texels) << static_cast<int>(type) << " " << size;
  }
  for (const char* const format : {"tif", "ppm", "exr", "hdr"}) {
    const ImageType type = format[0] == 't'   ? ImageType::tiff
                           : format[0] == 'p' ? ImageType::ppm
                           : format[0] == 'e' ? ImageType::exr
                                              : ImageType::hdr;
    const std::string whole = encoded(format);
    EXPECT_FALSE(decode(std::string_view(whole).substr(0, whole.size() / 2), type).texels) << format;
  }
}

TEST(TexelFile, huge_images_are_refused_by_their_header) {
  EXPECT_THAT(decode(png_header(100000) + png_chunk("IDATx"), ImageType::png).problem,
              HasSubstr("it has 100000x100000 pixels"));
  Budget budget(1'000'000);
  const DecodedTexels decoded = decode(png_header(60000) + png_chunk("IDATx"), ImageType::png, {.budget = &budget});
  EXPECT_TRUE(decoded.is_too_large);
  EXPECT_THAT(decoded.problem, HasSubstr("its 60000x60000 pixels take more memory than the limit leaves"));
  EXPECT_EQ(budget.held(), 0u);
}

TEST(TexelFile, pixels_are_charged_as_long_as_they_are_held) {
  Budget budget(1'000'000);
  DecodedTexels decoded = decode(kPalettePng, ImageType::png, {.budget = &budget});
  EXPECT_GE(budget.held(), 6u);
  decoded.texels.reset();
  EXPECT_EQ(budget.held(), 0u);
}

TEST(TexelFile, changed_bytes_do_no_harm) {
  std::mt19937 random(7);
  const auto expect_no_harm = [&random](std::string_view bytes, ImageType type, int rounds) {
    for (int round = 0; round < rounds; ++round) {
      std::string changed(bytes);
      for (int i = 0; i < 3; ++i) changed[random() % changed.size()] = static_cast<char>(random());
      Budget budget(100'000'000);
      const DecodedTexels decoded = decode(changed, type, {.budget = &budget});
      EXPECT_EQ(decoded.texels == nullptr, !decoded.problem.empty());
    }
  };
  expect_no_harm(kPalettePng, ImageType::png, 3000);
  expect_no_harm(kPaletteGif, ImageType::gif, 3000);
  expect_no_harm(encoded("jpg"), ImageType::jpeg, 300);
  expect_no_harm(encoded("tif"), ImageType::tiff, 300);
  expect_no_harm(encoded("ppm"), ImageType::ppm, 300);
  expect_no_harm(encoded("hdr"), ImageType::hdr, 300);
  expect_no_harm(encoded("exr"), ImageType::exr, 300);
}

}  // namespace
}  // namespace isl::render::test
