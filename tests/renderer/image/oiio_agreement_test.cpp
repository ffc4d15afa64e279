// PNG and EXR are written without OpenImageIO. OpenImageIO must read the same from these files as from the files that
// it writes itself for the same pictures: every attribute, every channel, every bit of the pixels.
#include "tests/renderer/image/oiio_reference.h"
#include "tests/renderer/image/test_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isl::render::test {
namespace {

const ImageFileOptions kOptions{
    .metadata = {{"Software", "isl 1"}, {"isl:Scene", "a scene, 100%"}, {"isl:Options", "-s 8x6 -D N=\"x y\""}}};

/// A smooth picture with an edge and some values out of range, and no long run of one value.
Image picture(const PixelRect& window, int full_width, int full_height) {
  Image image;
  image.full_width = full_width;
  image.full_height = full_height;
  image.window = window;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const double alpha = (x + 2 * y) % 7 / 6.0, light = 0.5 + 0.7 * std::sin(0.05 * x + 0.3 * y);
      image.rgba.insert(image.rgba.end(), {light * alpha, (x > y ? 0.9 : 0.01) * alpha, 1.0 / (1 + x) * alpha, alpha});
    }
  }
  return image;
}

void add_layers_to_compare(Image& image) {
  const auto fill = [&](const Aov& aov, double scale, double first) {
    Layer& layer = test::add_layer(image, aov);
    for (std::size_t i = 0; i < layer.values.size(); ++i) layer.values[i] = scale * static_cast<double>(i) + first;
    for (std::size_t pixel = 0; pixel < image.window.area(); ++pixel) layer.round(pixel);
  };
  fill(test::kDepth, 0.1, -1);
  image.layers.back().values[0] = std::numeric_limits<double>::infinity();
  fill(test::kNormal, 0.01, -1);
  fill(test::kCost, 100, -1);
  fill(test::kError, 1e-6, -1);
  // The last of 1200 values just fits into 32 bits, and most of them have more digits than a float holds.
  fill(test::kPrimitive, 3579139, 0);
  fill(test::kSamples, 1, 0);
  fill(test::kMissed, 2, 0);
}

void expect_agreement(const Image& image, const std::string& format, const ImageFileOptions& options) {
  const EncodedFile ours = encode_image(image, format, options);
  ASSERT_EQ(ours.error, "");
  const FileContent found = read_by_oiio(ours.bytes, format);
  const FileContent wanted = read_by_oiio(written_by_oiio(image, format, options), format);
  EXPECT_EQ(found.attributes, wanted.attributes);
  EXPECT_TRUE(found.pixels == wanted.pixels) << format << " " << image.window.width() << "x" << image.window.height();
}

TEST(OiioAgreement, png_of_every_kind) {
  for (const PixelRect window : {PixelRect{0, 0, 40, 30}, PixelRect{3, 5, 20, 9}, PixelRect{0, 0, 1, 1}}) {
    for (const bool has_alpha : {false, true}) {
      for (const int bits : {0, 8, 16}) {
        Image image = picture(window, 40, 30);
        image.has_alpha = has_alpha;
        expect_agreement(image, "png", {.metadata = kOptions.metadata, .bits = bits});
      }
    }
  }
}

TEST(OiioAgreement, png_without_metadata) { expect_agreement(picture({0, 0, 5, 4}, 5, 4), "png", {}); }

TEST(OiioAgreement, pictures_of_several_strips) {
  for (const bool has_alpha : {false, true}) {
    for (const int bits : {8, 16}) {
      Image image = picture({0, 0, 601, 487}, 601, 487);
      image.has_alpha = has_alpha;
      expect_agreement(image, "png", {.metadata = kOptions.metadata, .bits = bits, .threads = 3});
    }
  }
}

TEST(OiioAgreement, a_very_wide_picture) {
  const Image image = picture({0, 0, 65536, 2}, 65536, 2);
  expect_agreement(image, "png", kOptions);
  expect_agreement(image, "exr", kOptions);
}

TEST(OiioAgreement, exr_of_every_kind) {
  for (const PixelRect window : {PixelRect{0, 0, 40, 30}, PixelRect{3, 5, 20, 9}, PixelRect{0, 0, 1, 1}}) {
    for (const bool has_alpha : {false, true}) {
      for (const bool is_float : {false, true}) {
        Image image = picture(window, 40, 30);
        image.has_alpha = has_alpha;
        expect_agreement(image, "exr", {.metadata = kOptions.metadata, .exr_float = is_float});
        add_layers_to_compare(image);
        expect_agreement(image, "exr", {.metadata = kOptions.metadata, .exr_float = is_float});
      }
    }
  }
}

TEST(OiioAgreement, exr_without_metadata) { expect_agreement(picture({0, 0, 5, 4}, 5, 4), "exr", {}); }

TEST(OiioAgreement, names_that_are_not_ascii) {
  const ImageFileOptions options{.metadata = {{"isl:Scene", "Küche ☕"}}};
  for (const char* format : {"png", "exr"}) {
    const Image image = picture({0, 0, 5, 4}, 5, 4);
    const FileContent found = read_by_oiio(encode_image(image, format, options).bytes, format);
    EXPECT_NE(std::find(found.attributes.begin(), found.attributes.end(), "isl:Scene: string = Küche ☕"),
              found.attributes.end())
        << format;
  }
}

}  // namespace
}  // namespace isl::render::test
