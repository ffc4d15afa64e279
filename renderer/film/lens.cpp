#include "renderer/film/lens.h"

#include "renderer/patterns/patterns.h"
#include "renderer/queries/pattern_insides.h"

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

/// POV-Ray calls twice the lens's diameter the aperture.
constexpr double kDiameterOfAperture = 0.5;

/// Cells a side of the raster of a pigment over the lens: finer than a blurred point is seen.
constexpr std::size_t kBokehCells = 128;

DensityTable brightness(const scene::Pigment& pigment, const scene::Database& database, const RunLimits& run,
                        const ImageTable* images) {
  const PatternInsides insides(database);
  const Patterns patterns(database, &insides, database.settings.number_of_waves, images);
  values::Environment environment(values::noise_generator_of(database.settings.noise_generator), run, &patterns);
  std::vector<double> weights;
  weights.reserve(kBokehCells * kBokehCells);
  for (std::size_t row = 0; row < kBokehCells; ++row) {
    for (std::size_t column = 0; column < kBokehCells; ++column) {
      const auto middle = [](std::size_t cell) { return (static_cast<double>(cell) + 0.5) / kBokehCells; };
      const scene::Colour colour = patterns.pigment_colour(pigment, {middle(column), middle(row), 0}, environment);
      // The weights by which POV-Ray reduces a colour to one number.
      weights.push_back(std::max(0.0, 0.297 * colour.red + 0.589 * colour.green + 0.114 * colour.blue));
    }
  }
  return {kBokehCells, kBokehCells, std::move(weights)};
}

/// A point of the disc of diameter 1 for a point of the square of side 1, both about the origin: rings of squares
/// become circles, and equal areas stay equal (Shirley and Chiu, A Low Distortion Map Between Disk and Square, 1997).
UnitPoint on_disc(double x, double y) {
  if (x == 0 && y == 0) return {0, 0};
  constexpr double kEighth = std::numbers::pi / 4;
  const bool is_wide = std::abs(x) > std::abs(y);
  const double radius = is_wide ? x : y;
  const double angle = is_wide ? kEighth * (y / x) : 2 * kEighth - kEighth * (x / y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Lens::Lens(const scene::Database& database, const RunLimits& run, const ImageTable* images) {
  const scene::Camera& camera = *database.camera;
  const double diameter = kDiameterOfAperture * camera.blur->aperture;
  const Vec3 direction = camera.direction.normalized();
  across_ = camera.right.normalized() * diameter;
  upward_ = (camera.up - direction * camera.up.dot(direction)).normalized() * diameter;
  if (camera.blur->bokeh) bokeh_.emplace(brightness(*camera.blur->bokeh, database, run, images));
}

Vec3 Lens::offset(const UnitPoint& at) const {
  if (bokeh_) {
    const DensityTable::Place place = bokeh_->place(at);
    return across_ * (place.u - 0.5) + upward_ * (place.v - 0.5);
  }
  const UnitPoint point = on_disc(at.u - 0.5, at.v - 0.5);
  return across_ * point.u + upward_ * point.v;
}

}  // namespace isl::render
