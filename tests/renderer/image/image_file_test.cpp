// Files hold the picture's content, as OpenImageIO reads it back; the same picture gives the same bytes.
#include "renderer/image/image_file.h"
#include "renderer/image/transfer.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include "tests/renderer/image/test_layers.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <thread>

namespace isl::render::test {
namespace {

/// 3×2 pixels at (1, 1) of a picture of 8×6; some out of range, one half transparent.
Image sample_picture() {
  Image image;
  image.full_width = 8;
  image.full_height = 6;
  image.window = {1, 1, 4, 3};
  image.rgba = {0.5, 0.2, 0.01, 1, 0, 0, 0, 1, 1, 1, 1, 1, 2.5, -0.5, 0.25, 1, 0.1, 0.2, 0.3, 0.5, 0, 0, 0, 0};
  return image;
}

void add_layers(Image& image) {
  using test::add_layer;
  add_layer(image, test::kDepth, {1.25, 2, 3, 4, 1e9, std::numeric_limits<double>::infinity()});
  Layer& normal = add_layer(image, test::kNormal);
  for (int i = 0; i < 18; ++i) normal.values[static_cast<std::size_t>(i)] = static_cast<float>(i) / 18;
  add_layer(image, test::kPrimitive, {0, 1, 70000, 16777217, 5, 0xFFFFFFFFu});
  add_layer(image, test::kSamples, {1, 16, 1, 16, 1, 1});
}

/// A file's channels as floats, pixel by pixel.
struct ReadBack {
  OIIO::ImageSpec spec;
  std::vector<float> values;
  std::vector<std::uint32_t> ids;     ///< values of `primitive.id`, if that channel exists
  std::vector<std::uint32_t> counts;  ///< values of `samples.count`

  [[nodiscard]] float at(std::size_t pixel, const char* channel) const {
    return values[pixel * static_cast<std::size_t>(spec.nchannels) +
                  static_cast<std::size_t>(spec.channelindex(channel))];
  }
};

/// Writes the picture and reads it back. Throws if that fails, because the test cannot continue.
ReadBack through_file(const Image& image, const std::string& format, const ImageFileOptions& options = {}) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("isl_image_file_test.{}.{}", getpid(), format);
  const EncodedFile encoded = encode_image(image, format, options);
  if (!encoded.error.empty()) throw std::runtime_error(encoded.error);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(encoded.bytes.data()), static_cast<std::streamsize>(encoded.bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw std::runtime_error(OIIO::geterror());
  ReadBack result;
  result.spec = input->spec();
  result.values.resize(result.spec.image_pixels() * static_cast<std::size_t>(result.spec.nchannels));
  bool good = input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeDesc::FLOAT, result.values.data());
  for (auto [name, numbers] : {std::pair("primitive.id", &result.ids), std::pair("samples.count", &result.counts)}) {
    const int channel = result.spec.channelindex(name);
    if (channel < 0) continue;
    numbers->resize(result.spec.image_pixels());
    good = good && input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::UINT32, numbers->data());
  }
  if (!good) throw std::runtime_error(input->geterror());
  std::filesystem::remove(path);
  return result;
}

TEST(ImageFile, integer_formats_hold_clipped_srgb) {
  const Image image = sample_picture();
  for (const auto& [format, step] :
       {std::pair("png", 1.0 / 65535), std::pair("tif", 1.0 / 65535), std::pair("ppm", 1.0 / 255)}) {
    const ReadBack file = through_file(image, format);
    EXPECT_EQ(file.spec.nchannels, 3) << format;
    EXPECT_EQ(file.spec.width, 3);
    EXPECT_EQ(file.spec.height, 2);
    for (std::size_t pixel = 0; pixel < 6; ++pixel) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(file.values[3 * pixel + i], display_from_linear(image.rgba[4 * pixel + i]), 0.51 * step) << format;
      }
    }
  }
}

TEST(ImageFile, png_has_sixteen_bits_and_says_that_it_is_srgb) {
  const ReadBack file = through_file(sample_picture(), "png");
  EXPECT_EQ(file.spec.format, OIIO::TypeDesc::UINT16);
  EXPECT_EQ(file.spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
  EXPECT_EQ(std::lround(file.values[0] * 65535), 48192) << "what POV-Ray writes for 0.5";
  // The chunks agree, so that viewers that know only one of them show the same.
  const EncodedFile png = encode_image(sample_picture(), "png", {});
  const std::string bytes(png.bytes.begin(), png.bytes.end());
  for (const char* chunk : {"sRGB", "gAMA", "cHRM", "oFFs"}) EXPECT_NE(bytes.find(chunk), std::string::npos) << chunk;
}

TEST(ImageFile, integer_formats_have_the_bits_asked_for) {
  const Image image = sample_picture();
  for (const char* format : {"png", "tif"}) {
    for (const int bits : {8, 16}) {
      const ReadBack file = through_file(image, format, {.metadata = {}, .bits = bits});
      EXPECT_EQ(file.spec.format, bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16) << format;
      EXPECT_EQ(std::lround(file.values[0] * (bits == 8 ? 255 : 65535)), bits == 8 ? 188 : 48192) << format;
    }
    EXPECT_TRUE(encode_image(image, format, {}).bytes ==
                encode_image(image, format, {.metadata = {}, .bits = 16}).bytes);
  }
  EXPECT_EQ(through_file(image, "jpg", {.metadata = {}, .bits = 8}).spec.format, OIIO::TypeDesc::UINT8);
}

TEST(ImageFile, knows_which_formats_have_how_many_bits) {
  for (const char* format : {"png", "tif"}) EXPECT_TRUE(format_holds_bits(format, 8) && format_holds_bits(format, 16));
  for (const char* format : {"jpg", "ppm"}) EXPECT_TRUE(format_holds_bits(format, 8) && !format_holds_bits(format, 16));
  for (const char* format : {"exr", "hdr"}) EXPECT_TRUE(is_linear_format(format) && !format_holds_bits(format, 8));
}

TEST(ImageFile, alpha_is_kept_where_there_is_alpha) {
  Image image = sample_picture();
  image.has_alpha = true;
  for (const char* format : {"png", "tif"}) {
    const ReadBack file = through_file(image, format);
    ASSERT_EQ(file.spec.nchannels, 4) << format;
    EXPECT_NEAR(file.values[4 * 4 + 3], 0.5, 1e-5);
    EXPECT_NEAR(file.values[4 * 4 + 1], display_from_linear(0.4), 1e-5) << "colour is not multiplied by alpha";
    EXPECT_EQ(file.values[5 * 4 + 3], 0);
  }
  const ReadBack exr = through_file(image, "exr");
  EXPECT_NEAR(exr.at(4, "G"), 0.2, 1e-4) << "in EXR it is";
  EXPECT_EQ(exr.at(4, "A"), 0.5f);
  EXPECT_EQ(through_file(image, "jpg").spec.nchannels, 3);
}

TEST(ImageFile, exr_holds_linear_light_in_halfs_or_floats) {
  const Image image = sample_picture();
  const ReadBack halfs = through_file(image, "exr");
  EXPECT_EQ(halfs.spec.format, OIIO::TypeDesc::HALF);
  EXPECT_EQ(halfs.at(3, "R"), 2.5f);
  EXPECT_EQ(halfs.at(3, "G"), -0.5f);
  const ReadBack floats = through_file(image, "exr", {.metadata = {}, .exr_float = true});
  EXPECT_EQ(floats.spec.format, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(floats.at(0, "B"), 0.01f);
}

TEST(ImageFile, exr_holds_layers_exactly) {
  Image image = sample_picture();
  add_layers(image);
  const ReadBack file = through_file(image, "exr");
  EXPECT_EQ(file.at(0, "depth.Z"), 1.25f);
  EXPECT_TRUE(std::isinf(file.at(5, "depth.Z")));
  for (std::size_t pixel = 0; pixel < 6; ++pixel) {
    EXPECT_EQ(file.at(pixel, "normal.X"), image.layer("normal")->at(pixel, 0));
    EXPECT_EQ(file.at(pixel, "normal.Z"), image.layer("normal")->at(pixel, 2));
  }
  EXPECT_EQ(std::vector<double>(file.counts.begin(), file.counts.end()), image.layer("samples")->values);
  // Numbers of primitives are stored as 32-bit integers, not as floats.
  EXPECT_EQ(file.spec.channelformat(file.spec.channelindex("primitive.id")), OIIO::TypeDesc::UINT32);
  EXPECT_EQ(std::vector<double>(file.ids.begin(), file.ids.end()), image.layer("primitive")->values);
}

TEST(ImageFile, exr_knows_where_a_crop_stands) {
  const ReadBack file = through_file(sample_picture(), "exr");
  EXPECT_EQ(file.spec.x, 1);
  EXPECT_EQ(file.spec.y, 1);
  EXPECT_EQ(file.spec.full_width, 8);
  EXPECT_EQ(file.spec.full_height, 6);
}

TEST(ImageFile, jpg_and_hdr_are_close) {
  Image image = sample_picture();
  image.rgba.clear();
  for (int i = 0; i < 6; ++i) image.rgba.insert(image.rgba.end(), {0.5, 0.25, 0.125, 1});
  const ReadBack jpg = through_file(image, "jpg");
  EXPECT_NEAR(jpg.values[0], display_from_linear(0.5), 0.02);
  const ReadBack hdr = through_file(image, "hdr");
  EXPECT_NEAR(hdr.values[0], 0.5, 0.01);
  EXPECT_NEAR(hdr.values[2], 0.125, 0.01);
}

TEST(ImageFile, metadata_is_kept) {
  const ImageFileOptions options{.metadata = {{"Software", "isl 1"}, {"isl:scene", "a scene, 100%"}}};
  for (const char* format : {"png", "exr"}) {
    const ReadBack file = through_file(sample_picture(), format, options);
    EXPECT_EQ(file.spec.get_string_attribute("Software"), "isl 1") << format;
    EXPECT_EQ(file.spec.get_string_attribute("isl:scene"), "a scene, 100%") << format;
  }
}

TEST(ImageFile, the_same_picture_is_the_same_bytes_at_any_time) {
  const Image image = sample_picture();
  const std::string formats[] = {"png", "exr", "tif", "jpg", "ppm", "hdr"};
  std::vector<std::vector<unsigned char>> before;
  for (const std::string& format : formats) before.push_back(encode_image(image, format, {}).bytes);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // file headers count seconds
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_FALSE(before[i].empty());
    EXPECT_EQ(encode_image(image, formats[i], {}).bytes, before[i]) << formats[i];
  }
}

TEST(ImageFile, the_same_picture_is_the_same_bytes_with_any_number_of_threads) {
  Image image;  // large enough for several strips of compressed data
  image.full_width = 700;
  image.full_height = 500;
  image.window = {0, 0, 700, 500};
  for (std::size_t i = 0; i < 4 * image.window.area(); ++i) image.rgba.push_back(static_cast<double>(i % 1013) / 1013);
  for (const char* format : {"png", "exr"}) {
    const std::vector<unsigned char> one = encode_image(image, format, {}).bytes;
    for (const int threads : {2, 5}) {
      EXPECT_TRUE(encode_image(image, format, {.metadata = {}, .threads = threads}).bytes == one) << format;
    }
  }
}

TEST(ImageFile, knows_formats_by_the_name) {
  EXPECT_EQ(image_format_of("a/b.PNG"), "png");
  EXPECT_EQ(image_format_of("b.tiff"), "tif");
  EXPECT_EQ(image_format_of("b.jpeg"), "jpg");
  for (const char* none : {"", "png", "a.png/b", "a.bmp", "a.", ".d/x"}) EXPECT_EQ(image_format_of(none), "") << none;
}

TEST(ImageFile, a_picture_without_pixels_is_none) {
  EXPECT_EQ(encode_image({}, "png", {}).error, "the picture has no pixels: its window is empty");
}

}  // namespace
}  // namespace isl::render::test
