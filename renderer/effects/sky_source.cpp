#include "renderer/effects/sky_source.h"

#include "renderer/numerics/directions.h"

#include <cmath>
#include <numeric>

namespace isl::render {
namespace {

constexpr double kWholeSphere = 4 * std::numbers::pi;  ///< steradians

/// The raster of the table: cells of about 1.4 degrees.
constexpr std::size_t kColumns = 256, kRows = 128;

}  // namespace

SkySource::SkySource(std::span<const std::unique_ptr<const Stage<MissWork>>> stages, const Rgb& background)
    : stages_(stages), background_(background) {
  if (stages_.empty()) return;  // the same light from everywhere
  std::vector<Vec3> directions;
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      const auto middle = [](std::size_t cell, std::size_t count) {
        return (static_cast<double>(cell) + 0.5) / static_cast<double>(count);
      };
      directions.push_back(sphere_direction({middle(column, kColumns), middle(row, kRows)}));
    }
  }
  std::vector<Rgb> colours(directions.size());
  PathBatch batch;
  light(directions, colours, batch);
  std::vector<double> weights;
  weights.reserve(colours.size());
  for (const Rgb& colour : colours) weights.push_back(std::max(0.0, colour.x + colour.y + colour.z));
  // The share grows with the variance of the brightness, from nothing for an even sky to a half, where the cosine still
  // has enough directions for what the table's cells hide.
  const auto count = static_cast<double>(weights.size());
  const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / count;
  double variance = 0;
  for (const double weight : weights) variance += (weight - mean) * (weight - mean) / count;
  if (variance == 0) return;
  by_table_ = 0.5 * variance / (variance + mean * mean);
  table_.emplace(kColumns, kRows, std::move(weights));
}

void SkySource::light(std::span<const Vec3> directions, std::span<Rgb> light, PathBatch& batch) const {
  if (stages_.empty()) {
    std::ranges::fill(light, background_);
    return;
  }
  std::ranges::fill(light, Rgb(0));
  batch.clear();
  std::vector<std::uint32_t> numbers(directions.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  for (const std::uint32_t i : numbers) {
    Ray ray;
    ray.origin = Vec3(0);
    ray.direction = directions[i];
    batch.push(ray, {.sample = i});
  }
  MissWork work{batch, numbers, background_, 1, light, {}};
  for (const auto& stage : stages_) stage->run(work);
}

SkySource::Choice SkySource::choose(const UnitPoint& at, const Vec3& normal) const {
  Choice choice{};
  if (at.u < by_table_) {
    const DensityTable::Place place = table_->place({at.u / by_table_, at.v});
    choice.direction = sphere_direction({place.u, place.v});
  } else {
    choice.direction = cosine_direction({(at.u - by_table_) / (1 - by_table_), at.v}, normal);
  }
  // A direction may come from either way, so the densities of both add up (Veach and Guibas' balance heuristic, 1995).
  choice.density = (1 - by_table_) * std::max(0.0, choice.direction.dot(normal)) / std::numbers::pi;
  if (by_table_ > 0) {
    const UnitPoint place = sphere_point(choice.direction);
    choice.density += by_table_ * table_->density(place.u, place.v) / kWholeSphere;
  }
  return choice;
}

}  // namespace isl::render
