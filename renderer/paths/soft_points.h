// Points at which samples look at soft things, many at a time.
#pragma once

#include "renderer/numerics/sample_points.h"
#include "renderer/paths/pixel_sample.h"

#include <cstdint>
#include <span>

namespace isl::render {

/// The points of a sequence, moved together round the edges of the square so that number 0 is in the middle, from which
/// they are measured: both coordinates are in [-1/2, 1/2).
class CentredPoints {
 public:
  explicit CentredPoints(const PointSequence& sequence) : sequence_(sequence), middle_(sequence.place(0)) {}

  /// Sets `points` to those of the numbers from `first` on.
  void fill(std::uint32_t first, std::span<UnitPoint> points) const;

 private:
  PointSequence sequence_;
  SquarePlace middle_;
};

/// The points of the lens through which the samples of a pixel look.
[[nodiscard]] inline CentredPoints points_on_lens(std::uint32_t seed) {
  return CentredPoints({seed, derived_seed(seed, static_cast<std::uint32_t>(SampleUse::lens))});
}
/// The points of the pixel through which its samples look. With a lens, what a sample sees depends on its points in the
/// pixel and on the lens at once, so both come from one sequence.
[[nodiscard]] inline CentredPoints points_in_pixel(std::uint32_t seed, bool has_lens) {
  const std::uint32_t own = derived_seed(seed, static_cast<std::uint32_t>(SampleUse::pixel));
  return CentredPoints(has_lens ? PointSequence{seed, own, SobolPair::second} : PointSequence{own, own});
}

/// points[i] becomes places[i].point().
void set_points(std::span<const SoftPlace> places, std::span<UnitPoint> points);

/// These functions for one vector width.
struct SoftPointLoops {
  void (*fill)(const PointSequence& sequence, const SquarePlace& middle, std::uint32_t first,
               std::span<UnitPoint> points);
  void (*set)(std::span<const SoftPlace> places, std::span<UnitPoint> points);
};

}  // namespace isl::render
