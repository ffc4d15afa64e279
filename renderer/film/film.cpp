#include "renderer/film/film.h"

#include "base/check.h"

#include <algorithm>

namespace isl::render {
namespace {

void set_triple(std::vector<float>& layer, std::size_t pixel, const Vec3& value) {
  for (int i = 0; i < 3; ++i) layer[3 * pixel + static_cast<std::size_t>(i)] = static_cast<float>(value[i]);
}

/// Rows of `window` out of a layer that covers `rect`, `channels` values a pixel.
template <class Value>
std::vector<Value> cropped(const std::vector<Value>& layer, const PixelRect& rect, const PixelRect& window,
                           std::size_t channels) {
  std::vector<Value> result;
  if (layer.empty()) return result;
  result.reserve(window.area() * channels);
  for (int y = window.y0; y < window.y1; ++y) {
    const auto row = layer.begin() + static_cast<std::ptrdiff_t>(rect.index(window.x0, y) * channels);
    result.insert(result.end(), row, row + static_cast<std::ptrdiff_t>(channels) * window.width());
  }
  return result;
}

}  // namespace

Film::Film(const PixelRect& rect, const Aovs& aovs)
    : rect_(rect), aovs_(aovs), sums_(4 * rect.area()), counts_(rect.area()) {
  const std::size_t pixels = rect.area();
  if (aovs.depth) layers_.depth.assign(pixels, std::numeric_limits<float>::infinity());
  if (aovs.position) layers_.position.resize(3 * pixels);
  if (aovs.normal) layers_.normal.resize(3 * pixels);
  if (aovs.albedo) layers_.albedo.resize(3 * pixels);
  if (aovs.primitive) layers_.primitive.assign(pixels, scene::kNone);
}

void Film::set_surface(std::size_t pixel, const SeenSurface& seen) {
  if (seen.hit->is_miss()) return;
  if (aovs_.depth) layers_.depth[pixel] = static_cast<float>(seen.hit->t);
  if (aovs_.primitive) layers_.primitive[pixel] = seen.hit->instance;
  if (aovs_.position) set_triple(layers_.position, pixel, seen.point->position);
  if (aovs_.normal) set_triple(layers_.normal, pixel, seen.point->normal);
  if (aovs_.albedo) set_triple(layers_.albedo, pixel, seen.albedo);
}

std::array<double, 4> Film::mean(std::size_t pixel) const {
  const double count = std::max(counts_[pixel], 1u);
  const double* sum = &sums_[4 * pixel];
  return {sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count};
}

Image Film::develop(const PixelRect& window, int full_width, int full_height, bool has_alpha) const {
  ISL_CHECK(window.empty() ||
                (window.x0 >= rect_.x0 && window.y0 >= rect_.y0 && window.x1 <= rect_.x1 && window.y1 <= rect_.y1),
            "window outside the film");
  Image image;
  image.full_width = full_width;
  image.full_height = full_height;
  image.window = window;
  image.has_alpha = has_alpha;
  image.rgba.reserve(4 * window.area());
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const std::array<double, 4> value = mean(rect_.index(x, y));
      image.rgba.insert(image.rgba.end(), value.begin(), value.end());
    }
  }
  image.layers.depth = cropped(layers_.depth, rect_, window, 1);
  image.layers.position = cropped(layers_.position, rect_, window, 3);
  image.layers.normal = cropped(layers_.normal, rect_, window, 3);
  image.layers.albedo = cropped(layers_.albedo, rect_, window, 3);
  image.layers.primitive = cropped(layers_.primitive, rect_, window, 1);
  if (aovs_.samples) image.layers.samples = cropped(counts_, rect_, window, 1);
  return image;
}

}  // namespace isl::render
