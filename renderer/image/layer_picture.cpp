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

/// What stands below the picture: a bar of the map with numbers, or coloured words.
struct Legend {
  std::string title;
  bool has_scale = true;
  ColourScale scale;
  double step = 10;  ///< ratio from one number to the next
  struct Word {
    const char* text;
    Rgb colour;
  };
  std::vector<Word> words;
};

/// Dots of the legend's letters: so that they are read at the size that the picture is looked at.
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
  int free = 0;  // where the next number may begin
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
  draw_text(image, x, top + 2 * scale, legend.title, scale, kInk);
  x += (static_cast<int>(legend.title.size()) + 2) * kLetterWidth * scale;
  for (const Legend::Word& word : legend.words) {
    draw_text(image, x, top + 2 * scale, word.text, scale, word.colour);
    x += (static_cast<int>(std::string_view(word.text).size()) + 2) * kLetterWidth * scale;
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

/// `stride` values a pixel, of which the first counts.
template <class Value>
Image counts(const Image& image, const char* title, const std::vector<Value>& values, std::size_t stride) {
  double most = 0;
  for (std::size_t i = 0; i < values.size(); i += stride) most = std::max(most, static_cast<double>(values[i]));
  const ColourScale scale = count_scale(most);
  return painted(image, {title, true, scale, 2, {}}, [&](std::size_t pixel) {
    const double count = static_cast<double>(values[stride * pixel]);
    return count == 0 ? kBackgroundColour : false_colour(scale.share_of(count));
  });
}

Image errors(const Image& image) {
  return painted(image, {"error px", true, kErrorScale, 10, {{"missed or false", kMissedColour}}},
                 [&](std::size_t pixel) {
                   const double error = image.layers.error[2 * pixel];
                   return std::isinf(error) ? kMissedColour : false_colour(kErrorScale.share_of(error));
                 });
}

Image missed(const Image& image) {
  return painted(image, {"surfaces", false, {}, 10, {{"missed", kMissedColour}, {"false", kFalseColour}}},
                 [&](std::size_t pixel) {
                   const std::uint32_t kind = image.layers.missed[pixel];
                   return kind == 0 ? kBackgroundColour : kind == 1 ? kMissedColour : kFalseColour;
                 });
}

}  // namespace

ColourScale count_scale(double most) { return {1, std::exp2(std::ceil(std::log2(std::max(most, 2.0)))), true}; }

bool is_pictured_layer(std::string_view layer) {
  return layer == "cost" || layer == "error" || layer == "solver_steps" || layer == "missed";
}

Image layer_picture(const Image& image, std::string_view layer) {
  ISL_CHECK(is_pictured_layer(layer), "layer {}", layer);
  if (layer == "cost") return counts(image, "field evaluations", image.layers.cost, 2);
  if (layer == "solver_steps") return counts(image, "solver steps", image.layers.solver_steps, 1);
  return layer == "error" ? errors(image) : missed(image);
}

}  // namespace isl::render
