// The values of patterns and the colours of pigments at points. Functions of the language use them through
// renderer/values/pattern_source.h, textures directly. The formulas of the kinds are in kinds/. The surface that a
// point is on, if it is on one, is known to the environment (values::Environment).
#pragma once

#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/scene/database.h"
#include "renderer/values/function_machine.h"
#include "renderer/values/pattern_source.h"

#include <span>

namespace isl::render {

/// A pattern's value at a point, and that point in the pattern's own space, where the chosen entry is evaluated.
struct PatternPlace {
  scene::Vec3 point;
  double value;
};

/// Evaluates the patterns of one database, which may grow between calls. Immutable: threads share one object, each with
/// its own environment. Nested patterns recurse; scene::Function::pattern_depth bounds the depth.
class Patterns final : public values::PatternSource {
 public:
  /// `surroundings` may be null if there is no `object` pattern, and `images` if there are no images. `number_of_waves`
  /// is the scene's for pictures, and POV-Ray's default for functions that the scene itself calls; it is limited to
  /// kMaxWaves.
  explicit Patterns(const scene::Database& database, const PatternSurroundings* surroundings = nullptr,
                    int number_of_waves = scene::Settings{}.number_of_waves, const ImageTable* images = nullptr)
      : world_{database, *this, surroundings, number_of_waves, images} {}
  Patterns(const Patterns& other)
      : world_{other.world_.database, *this, other.world_.surroundings, other.world_.number_of_waves,
               other.world_.images} {}
  Patterns& operator=(const Patterns&) = delete;

  /// The value after warps, turbulence, frequency and waveform. `point` is in the space that the pattern is placed
  /// into. The value is from 0 to 1, rarely a little beyond; for patterns that choose from a list it is the item's
  /// index. For NaN the result is unspecified.
  [[nodiscard]] double pattern_value(const scene::Pattern& pattern, const scene::Vec3& point,
                                     values::Environment& environment) const noexcept override;
  /// The same without warps and turbulence, at a point of the pattern's own space.
  [[nodiscard]] double value_at_own_point(const scene::Pattern& pattern, const scene::Vec3& p,
                                          values::Environment& environment) const noexcept;
  /// A unit normal as bumps bend it, of unit length. Point and normal are in the space that the bumps are placed into.
  [[nodiscard]] scene::Vec3 bent(const scene::Normal& bumps, const scene::Vec3& point, const scene::Vec3& normal,
                                 values::Environment& environment) const noexcept;
  [[nodiscard]] PatternPlace look_up(const scene::Pattern& pattern, const scene::Vec3& point,
                                     values::Environment& environment) const noexcept;
  /// The colour in single precision, as in POV-Ray.
  [[nodiscard]] scene::Colour pigment_colour(const scene::Pigment& pigment, const scene::Vec3& point,
                                             values::Environment& environment) const noexcept override;

 private:
  /// The value at a point of the pattern's own space, before frequency and waveform.
  [[nodiscard]] double raw_value(const scene::Pattern& pattern, const scene::Vec3& p,
                                 values::Environment& environment) const noexcept;
  /// The same at several points near p.
  void values_near(const scene::Pattern& pattern, const scene::Vec3& p, std::span<const scene::Vec3> points,
                   std::span<double> values, values::Environment& environment) const noexcept;
  /// The weighted mean of all entries.
  [[nodiscard]] scene::Colour average(const scene::PigmentMap& map, const scene::Vec3& p,
                                      values::Environment& environment) const noexcept;
  /// In the bumps' own space: the mean of the normals that a map chooses, and those bent by the heights of the values.
  [[nodiscard]] scene::Vec3 bent_by_map(const scene::Normal& bumps, const scene::Vec3& p, const scene::Vec3& normal,
                                        values::Environment& environment) const noexcept;
  [[nodiscard]] scene::Vec3 bent_by_heights(const scene::Normal& bumps, const scene::Vec3& p, const scene::Vec3& normal,
                                            values::Environment& environment) const noexcept;

  const PatternWorld world_;
};

}  // namespace isl::render
