// Runs a scene::Function: called by the interpreter where a scene calls one, and by the renderer for every point at
// which a pattern or a surface asks. Knows no text and no names. Nothing is allocated: the caller's frame of doubles
// holds arguments, intermediate values, results, and the frames of the functions that are called.
#pragma once

#include "base/check.h"
#include "renderer/scene/function.h"
#include "renderer/values/noise.h"
#include "renderer/values/pattern_source.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace isl::values {

/// What an evaluation needs besides the function: one a thread.
class Environment {
 public:
  /// `steps` bounds the turns of `sum` and `prod`, the calls and the patterns within all evaluations. When they are
  /// spent, what is left to do is skipped and the result means nothing.
  /// `patterns` answers for functions of patterns and pigments; null where there are none.
  explicit Environment(NoiseGenerator noise_generator, std::uint64_t steps = std::numeric_limits<std::uint64_t>::max(),
                       const PatternSource* patterns = nullptr)
      : noise_generator_(noise_generator), steps_(steps), patterns_(patterns) {}

  [[nodiscard]] NoiseGenerator noise_generator() const noexcept { return noise_generator_; }
  [[nodiscard]] const PatternSource& patterns() const noexcept {
    ISL_DCHECK(patterns_, "a function of a pattern was called without patterns");
    return *patterns_;
  }
  /// One more turn, call or pattern; false where there is none left.
  [[nodiscard]] bool take_step() noexcept {
    if (steps_ == 0) return false;
    --steps_;
    return true;
  }
  [[nodiscard]] bool is_spent() const noexcept { return steps_ == 0; }
  /// (u, v, 0) of the surface that is looked at, for patterns with `uv_mapping`; null where there is none, and these take
  /// the point itself. Whoever sets it keeps it.
  [[nodiscard]] const scene::Vec3* coordinates() const noexcept { return coordinates_; }
  void set_coordinates(const scene::Vec3* coordinates) noexcept { coordinates_ = coordinates; }

 private:
  NoiseGenerator noise_generator_;
  std::uint64_t steps_;
  const PatternSource* patterns_;
  const scene::Vec3* coordinates_ = nullptr;
};

/// One operation on numbers alone (those up to `radians` in scene::Opcode); b is ignored where it takes one.
/// What the machine itself runs, and what folds constants.
[[nodiscard]] double apply(scene::Opcode operation, double a, double b) noexcept;

/// `frame` has function.frame_size doubles, of which the first hold the arguments; afterwards the first hold the
/// results. Arguments outside of a domain give what IEEE arithmetic gives: NaN and infinities travel on, nothing fails.
void evaluate(const scene::Function& function, double* frame, Environment& environment) noexcept;

/// The results, the rest zero. `arguments` are as many as the function has parameters.
[[nodiscard]] std::array<double, 5> evaluate(const scene::Function& function, std::span<const double> arguments,
                                             Environment& environment) noexcept;

}  // namespace isl::values
