#include "renderer/image/layer_picture.h"

#include "base/check.h"
#include "renderer/image/tiny_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isl::render {
namespace {

const Rgb kPaper{0.0}, kInk{0.7};

/// The legend below the picture: a bar of the map with numbers, or coloured words.
struct Legend {
  const AovPicture& words;
  bool has_scale = true;
  ColourScale scale;
  double step = 10;  ///< ratio of neighbouring numbers
};

/// Pixels in a dot of the legend's letters, so that they can be read at the size at which the picture is viewed.
int scale_of(const Image& image) { return std::max(1, image.window.width() / 480); }

int legend_height(int scale) { return (3 * kLetterHeight + 8) * scale; }

void fill(Image& image, int x0, int y0, int width, int height, const Rgb& colour) {
  for (int y = y0; y < y0 + height; ++y) {
    for (int x = std::max(x0, 0); x < std::min(x0 + width, image.window.width()); ++x) {
      double* rgba = &image.rgba[4 * image.window.index(x, y)];
      for (int i = 0; i < 3; ++i) rgba[i] = colour[i];
      rgba[3] = 1;
    }
  }
}

void draw_scale(Image& image, int top, int scale, const Legend& legend) {
  const int margin = 3 * kLetterWidth * scale, width = std::max(1, image.window.width() - 2 * margin);
  for (int x = 0; x < width; ++x) {
    fill(image, margin + x, top, 1, kLetterHeight * scale, false_colour((x + 0.5) / width));
  }
  int free = 0;  // the x at which the next number may begin
  const int last =
      static_cast<int>(std::lround(std::log(legend.scale.high / legend.scale.low) / std::log(legend.step)));
  for (int i = 0; i <= last; ++i) {
    const double value = legend.scale.low * std::pow(legend.step, i);
    const std::string text = fmt::format("{:.4g}", value);
    const int length = static_cast<int>(text.size()) * kLetterWidth * scale;
    const int x = margin + static_cast<int>(legend.scale.share_of(value) * width) - length / 2;
    if (x < free || x + length > image.window.width()) continue;
    draw_text(image, x, top + (kLetterHeight + 2) * scale, text, scale, kInk);
    free = x + length + kLetterWidth * scale;
  }
}

void draw_legend(Image& image, int top, int scale, const Legend& legend) {
  fill(image, 0, top, image.window.width(), legend_height(scale), kPaper);
  int x = kLetterWidth * scale;
  draw_text(image, x, top + 2 * scale, std::string(legend.words.title), scale, kInk);
  x += (static_cast<int>(legend.words.title.size()) + 2) * kLetterWidth * scale;
  for (const AovPicture::Word& word : legend.words.words) {
    draw_text(image, x, top + 2 * scale, std::string(word.text), scale, word.colour);
    x += (static_cast<int>(word.text.size()) + 2) * kLetterWidth * scale;
  }
  if (legend.has_scale) draw_scale(image, top + (kLetterHeight + 4) * scale, scale, legend);
}

template <class ColourOf>
Image painted(const Image& image, const Legend& legend, const ColourOf& colour_of) {
  const int scale = scale_of(image);
  Image picture;
  picture.full_width = image.window.width();
  picture.full_height = image.window.height() + legend_height(scale);
  picture.window = {0, 0, picture.full_width, picture.full_height};
  picture.rgba.resize(4 * picture.window.area());
  for (std::size_t pixel = 0; pixel < image.window.area(); ++pixel) {
    const Rgb colour = colour_of(pixel);
    double* rgba = &picture.rgba[4 * pixel];
    for (int i = 0; i < 3; ++i) rgba[i] = colour[i];
    rgba[3] = 1;
  }
  draw_legend(picture, image.window.height(), scale, legend);
  return picture;
}

Image counts(const Image& image, const Layer& layer) {
  double most = 0;
  for (std::size_t pixel = 0; pixel < image.window.area(); ++pixel) most = std::max(most, layer.at(pixel, 0));
  const ColourScale scale = count_scale(most);
  return painted(image, {layer.aov->picture, true, scale, 2}, [&](std::size_t pixel) {
    const double count = layer.at(pixel, 0);
    return count == 0 ? kBackgroundColour : false_colour(scale.share_of(count));
  });
}

Image errors(const Image& image, const Layer& layer) {
  return painted(image, {layer.aov->picture, true, kErrorScale, 10}, [&](std::size_t pixel) {
    const double error = layer.at(pixel, 0);
    return std::isinf(error) ? layer.aov->picture.words[0].colour : false_colour(kErrorScale.share_of(error));
  });
}

Image kinds(const Image& image, const Layer& layer) {
  return painted(image, {layer.aov->picture, false, {}, 10}, [&](std::size_t pixel) {
    const auto kind = static_cast<std::size_t>(layer.at(pixel, 0));
    return kind == 0 ? kBackgroundColour : layer.aov->picture.words[kind - 1].colour;
  });
}

}  // namespace

ColourScale count_scale(double most) { return {1, std::exp2(std::ceil(std::log2(std::max(most, 2.0)))), true}; }

Image layer_picture(const Image& image, const Layer& layer) {
  switch (layer.aov->picture.kind) {
    case AovPicture::Kind::counts: return counts(image, layer);
    case AovPicture::Kind::errors: return errors(image, layer);
    case AovPicture::Kind::kinds: return kinds(image, layer);
    case AovPicture::Kind::none: break;
  }
  ISL_CHECK(false, "layer {} has no picture", layer.aov->name);
}

}  // namespace isl::render
