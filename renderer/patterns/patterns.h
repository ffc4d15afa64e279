// The values of patterns and the colours of pigments at points. The language asks through functions
// (renderer/values/pattern_source.h); textures ask here. What each kind of pattern
// computes stands in kinds/. Knows no text, no rays and of the surface only its
// coordinates (values::Environment): what depends on more of it (slope, aoi) is 0, as in POV-Ray's functions.
#pragma once

#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/scene/database.h"
#include "renderer/values/function_machine.h"
#include "renderer/values/pattern_source.h"

namespace isl::render {

/// A pattern's value at a point, and that point in the pattern's own space, where what it chooses is looked up.
struct PatternPlace {
  scene::Vec3 point;
  double value;
};

/// The patterns of one database, which may grow between calls. Immutable; threads share one, each with its own
/// environment. Patterns in patterns recurse: whoever makes them bounds their depth (scene::Function::pattern_depth).
class Patterns final : public values::PatternSource {
 public:
  /// `surroundings` may be null where no `object` pattern is. `number_of_waves`: at most kMaxWaves count; the scene's
  /// for pictures, while functions called by the scene itself always take POV-Ray's default.
  explicit Patterns(const scene::Database& database, const PatternSurroundings* surroundings = nullptr,
                    int number_of_waves = scene::Settings{}.number_of_waves)
      : world_{database, *this, surroundings, number_of_waves} {}
  Patterns(const Patterns& other)
      : world_{other.world_.database, *this, other.world_.surroundings, other.world_.number_of_waves} {}
  Patterns& operator=(const Patterns&) = delete;

  /// `point` in the space that the pattern is placed into. After warps, turbulence, frequency and wave: from 0 to 1 and
  /// rarely a little beyond; the item's number from 0 on for patterns that choose from a list. NaN in, anything out.
  [[nodiscard]] double pattern_value(const scene::Pattern& pattern, const scene::Vec3& point,
                                     values::Environment& environment) const noexcept override;
  [[nodiscard]] PatternPlace look_up(const scene::Pattern& pattern, const scene::Vec3& point,
                                     values::Environment& environment) const noexcept;
  /// In single precision, as POV-Ray's colours are.
  [[nodiscard]] scene::Colour pigment_colour(const scene::Pigment& pigment, const scene::Vec3& point,
                                             values::Environment& environment) const noexcept override;

 private:
  /// At a point of the pattern's own space, before frequency and wave.
  [[nodiscard]] double raw_value(const scene::Pattern& pattern, const scene::Vec3& p,
                                 values::Environment& environment) const noexcept;
  /// The weighted mean of all entries.
  [[nodiscard]] scene::Colour average(const scene::PigmentMap& map, const scene::Vec3& p,
                                      values::Environment& environment) const noexcept;

  const PatternWorld world_;
};

}  // namespace isl::render
