#include "cli/accuracy/pictures.h"

#include "cli/accuracy/base64.h"
#include "renderer/image/image_file.h"
#include "renderer/image/layer_picture.h"

#include <algorithm>
#include <cmath>

namespace isl::cli {
namespace {

using render::RayOutcome;

/// Steps of the colour map in pictures: more than an eye can distinguish, few enough for a small file.
constexpr double kColours = 96;

render::Rgb colour_of(const render::ColourScale& scale, double value) {
  return render::false_colour(std::round(std::clamp(scale.share_of(value), 0.0, 1.0) * kColours) / kColours);
}

render::Rgb error_colour(const render::RayError& error) {
  switch (error.outcome) {
    case RayOutcome::background: return render::kBackgroundColour;
    case RayOutcome::missed: return render::kMissedColour;
    case RayOutcome::false_surface: return render::kFalseColour;
    case RayOutcome::undecided: return render::kUndecidedColour;
    case RayOutcome::hit: break;
  }
  return colour_of(render::kErrorScale, error.pixels);
}

/// The scale reaches to the highest cost of any ray of any setting.
render::ColourScale cost_scale(const AccuracyReport& report) {
  double most = 0;
  for (const render::Measured& measured : report.comparison.settings) {
    for (const render::RayMeasure& ray : measured.rays)
      most = std::max(most, static_cast<double>(ray.counters.field_evaluations));
  }
  return render::count_scale(most);
}

template <class ColourOf>
render::Image painted(const PictureSize& size, const ColourOf& colour_of_pixel) {
  render::Image image;
  image.full_width = size.width;
  image.full_height = size.height;
  image.window = {0, 0, size.width, size.height};
  image.rgba.reserve(4 * image.window.area());
  for (std::size_t pixel = 0; pixel < image.window.area(); ++pixel) {
    const render::Rgb colour = colour_of_pixel(pixel);
    image.rgba.insert(image.rgba.end(), {colour.x, colour.y, colour.z, 1});
  }
  return image;
}

}  // namespace

AccuracyPictures accuracy_pictures(const AccuracyReport& report, const render::Image& scene) {
  AccuracyPictures pictures{{render::kErrorScale, cost_scale(report)}, {}, {}, {}, {}};
  const auto address_of = [&pictures](const render::Image& image) {
    const render::EncodedFile file = render::encode_image(image, "png", {});
    if (!file.error.empty()) pictures.problem = file.error;
    return "data:image/png;base64," + base64(file.bytes);
  };
  pictures.scene = address_of(scene);
  for (const render::Measured& measured : report.comparison.settings) {
    pictures.errors.push_back(
        address_of(painted(report.size, [&](std::size_t i) { return error_colour(measured.errors[i]); })));
    pictures.costs.push_back(address_of(painted(report.size, [&](std::size_t i) {
      const auto evaluations = static_cast<double>(measured.rays[i].counters.field_evaluations);
      return evaluations == 0 ? render::kBackgroundColour : colour_of(pictures.scales.cost, evaluations);
    })));
  }
  return pictures;
}

}  // namespace isl::cli
