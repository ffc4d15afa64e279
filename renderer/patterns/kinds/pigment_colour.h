// Blending of colours in single precision, as in POV-Ray.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/values/single_precision.h"

namespace isl::render {

/// Rounds every term to a float.
[[nodiscard]] inline scene::Colour in_single(const scene::Colour& c) noexcept {
  using values::to_single;
  return {to_single(c.red), to_single(c.green), to_single(c.blue), to_single(c.filter), to_single(c.transmit)};
}
/// (1 − fraction) · first + fraction · second; the terms of both are rounded to floats first.
[[nodiscard]] scene::Colour blend(const scene::Colour& first, const scene::Colour& second, double fraction) noexcept;
/// A weighted mean whose sum is rounded to single precision at each step.
class WeightedMean {
 public:
  void add(const scene::Colour& colour, double weight) noexcept;
  /// The mean; black where the weights sum to 0.
  [[nodiscard]] scene::Colour colour() const noexcept;

 private:
  scene::Colour sum_{};
  double total_ = 0;
};

/// Brightness with POV-Ray's weights of red, green and blue.
[[nodiscard]] double gray(const scene::Colour& colour) noexcept;

}  // namespace isl::render
