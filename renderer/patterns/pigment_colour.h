// Choosing from a map of pigments by a value, in single precision where POV-Ray's colours are.
#pragma once

#include "renderer/scene/pigment.h"

namespace isl::render {

/// The two entries around a value, and how far it is from the first to the second.
struct MapInterval {
  const scene::PigmentEntry* first;
  const scene::PigmentEntry* second;  ///< may be the same
  double fraction;
};
/// In a map that is not empty; NaN takes its last entry.
[[nodiscard]] MapInterval find_in(const scene::PigmentMap& map, double value) noexcept;

/// Every term rounded to a float.
[[nodiscard]] scene::Colour in_single(const scene::Colour& colour) noexcept;
[[nodiscard]] scene::Colour blend(const scene::Colour& first, const scene::Colour& second, double fraction) noexcept;
/// Every step of the sum rounded.
class WeightedMean {
 public:
  void add(const scene::Colour& colour, double weight) noexcept;
  /// Of weights that sum to 0: NaN or infinite.
  [[nodiscard]] scene::Colour colour() const noexcept;

 private:
  scene::Colour sum_{};
  double total_ = 0;
};

/// POV-Ray's weights of the eye.
[[nodiscard]] double gray(const scene::Colour& colour) noexcept;

}  // namespace isl::render
