#include "renderer/image/layer_picture.h"

#include "renderer/image/tiny_text.h"
#include "tests/renderer/image/test_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isl::render {
namespace {

Image measured(int width, int height) {
  Image image;
  image.full_width = width;
  image.full_height = height;
  image.window = {0, 0, width, height};
  return image;
}

Rgb colour_at(const Image& image, int x, int y) {
  const double* rgba = &image.rgba[4 * image.window.index(x, y)];
  return {rgba[0], rgba[1], rgba[2]};
}

TEST(LayerPictures, ShowErrorsOnOneScale) {
  Image image = measured(200, 50);
  Layer& layer = test::add_layer(image, test::kError);
  layer.at(1)[0] = 0.1;
  layer.at(2)[0] = std::numeric_limits<double>::infinity();
  const Image picture = layer_picture(image, layer);
  EXPECT_EQ(colour_at(picture, 0, 0), false_colour(0));
  EXPECT_LT((colour_at(picture, 1, 0) - false_colour(0.5)).length(), 1e-6);
  EXPECT_EQ(colour_at(picture, 2, 0), kMissedColour);
}

TEST(LayerPictures, ShowCountsUpToTheGreatest) {
  Image image = measured(200, 50);
  Layer& layer = test::add_layer(image, test::kCost);
  layer.at(1)[0] = 64;
  layer.at(2)[0] = 1;
  const Image picture = layer_picture(image, layer);
  EXPECT_EQ(colour_at(picture, 0, 0), kBackgroundColour);
  EXPECT_EQ(colour_at(picture, 1, 0), false_colour(1));
  EXPECT_EQ(colour_at(picture, 2, 0), false_colour(0));
}

TEST(LayerPictures, TellWhatIsMissedFromWhatIsInvented) {
  Image image = measured(200, 50);
  Layer& layer = test::add_layer(image, test::kMissed);
  layer.at(1)[0] = 1;
  layer.at(2)[0] = 2;
  const Image picture = layer_picture(image, layer);
  EXPECT_EQ(colour_at(picture, 1, 0), kMissedColour);
  EXPECT_EQ(colour_at(picture, 2, 0), kFalseColour);
}

TEST(LayerPictures, HaveALegendBelow) {
  Image image = measured(300, 50);
  const Image picture = layer_picture(image, test::add_layer(image, test::kError));
  EXPECT_EQ(picture.window.width(), 300);
  ASSERT_GT(picture.window.height(), 50);
  const int bar = 50 + kLetterHeight + 6;
  EXPECT_EQ(colour_at(picture, 3 * kLetterWidth, bar), false_colour(0.5 / (300 - 6 * kLetterWidth)));
  EXPECT_GT(colour_at(picture, 299 - 3 * kLetterWidth, bar).x, 0.9) << "yellow at its right end";
}

TEST(LayerPictures, ManageWithoutRoomForALegend) {
  for (const Aov* aov : {&test::kCost, &test::kError, &test::kMissed}) {
    Image image = measured(1, 1);
    const Image picture = layer_picture(image, test::add_layer(image, *aov));
    EXPECT_EQ(picture.window.width(), 1) << aov->name;
    EXPECT_EQ(picture.rgba.size(), 4 * picture.window.area()) << aov->name;
  }
}

TEST(TinyTexts, DrawDotsAndNothingOutside) {
  Image image;
  image.window = {0, 0, 8, 9};
  image.rgba.assign(4 * image.window.area(), 0);
  draw_text(image, 1, 1, "1", 1, {1, 1, 1});
  EXPECT_EQ(colour_at(image, 3, 1), Rgb(1.0)) << "the top of the stem";
  EXPECT_EQ(colour_at(image, 1, 1), Rgb(0.0));
  EXPECT_EQ(colour_at(image, 2, 7), Rgb(1.0)) << "the foot";
  draw_text(image, 6, -3, "888", 3, {1, 1, 1});  // across the border: only the part inside is drawn
}

}  // namespace
}  // namespace isl::render
