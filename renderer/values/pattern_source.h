// The interface by which a function asks for the value of a pattern or the colour of a pigment. renderer/patterns
// implements it; since a pattern may be a function itself, this interface stands between the two.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/pattern.h"
#include "renderer/scene/pigment.h"

namespace isl::values {

class Environment;

class PatternSource {
 public:
  virtual ~PatternSource() = default;

  /// The value of POV-Ray's `function { pattern { … } }`: from 0 to about 1, or the item's number for block patterns.
  [[nodiscard]] virtual double pattern_value(const scene::Pattern& pattern, const scene::Vec3& point,
                                             Environment& environment) const noexcept = 0;
  [[nodiscard]] virtual scene::Colour pigment_colour(const scene::Pigment& pigment, const scene::Vec3& point,
                                                     Environment& environment) const noexcept = 0;
};

}  // namespace isl::values
