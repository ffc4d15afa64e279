#include "renderer/accuracy/ray_errors.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

double quantile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(ascending.size()));
  return ascending[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

/// True if the reference has a surface at the pixel and at all eight around it; false at the picture's border.
bool is_within_surface(std::span<const RayError> errors, std::size_t width, std::size_t pixel) {
  const std::size_t x = pixel % width, y = pixel / width;
  if (x == 0 || y == 0 || x + 1 == width || (y + 2) * width > errors.size()) return false;
  for (std::size_t row = y - 1; row <= y + 1; ++row) {
    for (std::size_t column = x - 1; column <= x + 1; ++column) {
      const RayOutcome outcome = errors[row * width + column].outcome;
      if (outcome != RayOutcome::hit && outcome != RayOutcome::missed) return false;
    }
  }
  return true;
}

}  // namespace

RayError error_of(const Ray& ray, const RayMeasure& found, const ReferenceHit& reference, double pixel_angle) {
  if (reference.knowledge == Knowledge::undecided) return {.outcome = RayOutcome::undecided};
  if (reference.is_miss()) return {.outcome = found.is_miss() ? RayOutcome::background : RayOutcome::false_surface};
  if (found.is_miss()) return {.outcome = RayOutcome::missed};
  const double units = std::abs(found.t - reference.t);
  return {
      .outcome = RayOutcome::hit, .units = units, .pixels = units / (pixel_angle * (ray.path_length + reference.t))};
}

ErrorSummary summarise_errors(std::span<const RayError> errors, int width) {
  ISL_CHECK(width >= 1 && errors.size() % static_cast<std::size_t>(width) == 0, "{} {}", errors.size(), width);
  ErrorSummary summary;
  std::vector<double> pixels;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const RayError& error = errors[i];
    switch (error.outcome) {
      case RayOutcome::background: break;
      case RayOutcome::hit:
        pixels.push_back(error.pixels);
        summary.worst_units = std::max(summary.worst_units, error.units);
        if (error.pixels > 1) ++summary.beyond_pixel;
        break;
      case RayOutcome::missed:
        ++summary.missed;
        if (is_within_surface(errors, static_cast<std::size_t>(width), i)) ++summary.holes;
        break;
      case RayOutcome::false_surface: ++summary.false_surfaces; break;
      case RayOutcome::undecided: ++summary.undecided; break;
    }
  }
  std::sort(pixels.begin(), pixels.end());
  summary.hits = pixels.size();
  summary.median_pixels = quantile(pixels, 0.5);
  summary.p99_pixels = quantile(pixels, 0.99);
  summary.worst_pixels = quantile(pixels, 1);
  return summary;
}

}  // namespace isl::render
