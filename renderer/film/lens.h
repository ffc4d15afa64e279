// The lens of a camera with focal blur. A sample's ray starts at a point of the lens and meets the ray through its
// middle where the camera is in focus. The lens is a disc of half the aperture's diameter, as in POV-Ray; or, with
// `bokeh`, a square of that side, whose points are chosen by the brightness of a pigment.
#pragma once

#include "base/run_limits.h"
#include "renderer/numerics/density_table.h"
#include "renderer/patterns/kinds/sampled_image.h"
#include "renderer/scene/database.h"

#include <optional>
#include <span>

namespace isl::render {

using scene::Vec3;

/// Immutable; shared by all threads.
class Lens {
 public:
  /// Precondition: the database's camera has focal blur. `images` may be null if there are none of them.
  Lens(const scene::Database& database, const RunLimits& run, const ImageTable* images);

  /// Moves points of the unit square, measured from its middle, to the lens, in units of its width from its middle. The
  /// middle of the square belongs to that of the lens.
  void set_on_lens(std::span<UnitPoint> points) const;
  /// The way from the lens's middle to such a point.
  [[nodiscard]] Vec3 offset(const UnitPoint& on_lens) const { return across_ * on_lens.u + upward_ * on_lens.v; }

 private:
  Vec3 across_, upward_;  ///< as long as the lens is wide
  std::optional<DensityTable> bokeh_;
};

}  // namespace isl::render
