// Blending colours in single precision, where POV-Ray's are.
#pragma once

#include "renderer/scene/colour.h"

namespace isl::render {

/// Every term rounded to a float.
[[nodiscard]] scene::Colour in_single(const scene::Colour& colour) noexcept;
[[nodiscard]] scene::Colour blend(const scene::Colour& first, const scene::Colour& second, double fraction) noexcept;
/// Every step of the sum rounded.
class WeightedMean {
 public:
  void add(const scene::Colour& colour, double weight) noexcept;
  /// The mean; NaN or infinite where the weights sum to 0.
  [[nodiscard]] scene::Colour colour() const noexcept;

 private:
  scene::Colour sum_{};
  double total_ = 0;
};

/// POV-Ray's weights of the eye.
[[nodiscard]] double gray(const scene::Colour& colour) noexcept;

}  // namespace isl::render
