#include "renderer/film/lens.h"

#include "renderer/film/recurring_angles.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/insides.h"

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
  const Insides insides(database, run);
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

/// The sine and cosine of an angle of at most π/4, by their series. The first terms that are left out bound the error
/// by 2e-9, which moves a point of the lens by that share of its radius.
SineCosine of_small(double angle) {
  const double a = angle * angle;
  return {angle * (1 + a * (-1.0 / 6 + a * (1.0 / 120 + a * (-1.0 / 5040 + a * (1.0 / 362880))))),
          1 + a * (-1.0 / 2 + a * (1.0 / 24 + a * (-1.0 / 720 + a * (1.0 / 40320 + a * (-1.0 / 3628800)))))};
}

/// A point of the disc of diameter 1 for a point of the square of side 1, both about the origin: rings of squares
/// become circles, and equal areas stay equal (Shirley and Chiu, A Low Distortion Map Between Disk and Square, 1997).
UnitPoint on_disc(const UnitPoint& at) {
  const bool is_wide = std::abs(at.u) > std::abs(at.v);
  const double radius = is_wide ? at.u : at.v, shorter = is_wide ? at.v : at.u;
  // The middle stays where it is, whatever its angle.
  const auto [sine, cosine] = of_small(std::numbers::pi / 4 * (shorter / (radius == 0 ? 1 : radius)));
  const double along = radius * cosine, across = radius * sine;
  return {is_wide ? along : across, is_wide ? across : along};
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

void Lens::set_on_lens(std::span<UnitPoint> points) const {
  if (bokeh_) {
    for (UnitPoint& point : points) {
      const DensityTable::Place place = bokeh_->place({point.u + 0.5, point.v + 0.5});
      point = {place.u - 0.5, place.v - 0.5};
    }
  } else {
    for (UnitPoint& point : points) point = on_disc(point);
  }
}

}  // namespace isl::render
