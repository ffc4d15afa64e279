// Runs a scene::Function. The interpreter calls it where a scene calls a function, and the renderer calls it for every
// point of a pattern or surface. Knows no text and no names. Nothing is allocated: the caller's frame of doubles holds
// arguments, intermediate values, results, and the frames of the functions that are called.
#pragma once

#include "base/check.h"
#include "base/run_limits.h"
#include "renderer/scene/function.h"
#include "renderer/values/noise.h"
#include "renderer/values/pattern_source.h"

#include <array>
#include <cstdint>
#include <span>

namespace isl::values {

/// The surface that is evaluated, in the world. It refers to vectors that few patterns ask for: to copy them where they
/// have just been made would take longer than to make them.
struct SurfaceView {
  const scene::Vec3* point = nullptr;
  const scene::Vec3* normal = nullptr;     ///< unit, turned to the viewer, bent by bumps
  const scene::Vec3* direction = nullptr;  ///< unit, from the viewer to the point
};

/// The state that an evaluation needs besides the function, one for each thread.
class Environment {
 public:
  /// `run` limits the turns of `sum` and `prod`, the calls, the patterns and the turns of their own long loops within
  /// all evaluations. When the steps are spent or the run is stopped, the rest is skipped and the result is
  /// meaningless. `patterns` evaluates functions of patterns and pigments; it is null if there are none.
  explicit Environment(NoiseGenerator noise_generator, const RunLimits& run = {},
                       const PatternSource* patterns = nullptr)
      : noise_generator_(noise_generator), steps_(run.steps_at_point, run.stop), patterns_(patterns) {}

  [[nodiscard]] NoiseGenerator noise_generator() const noexcept { return noise_generator_; }
  [[nodiscard]] const PatternSource& patterns() const noexcept {
    ISL_DCHECK(patterns_, "a function of a pattern was called without patterns");
    return *patterns_;
  }
  /// Counts one more turn, call or pattern; false if no steps are left.
  [[nodiscard]] bool take_step() noexcept { return steps_.take(); }
  [[nodiscard]] bool is_spent() const noexcept { return steps_.is_spent(); }
  /// The counter itself, for work that takes many steps at once.
  [[nodiscard]] StepCounter& steps() noexcept { return steps_; }
  /// (u, v, 0) of the surface point that is evaluated, for patterns with `uv_mapping`. If it is null, they take the
  /// point itself. It belongs to the caller of set_coordinates.
  [[nodiscard]] const scene::Vec3* coordinates() const noexcept { return coordinates_; }
  void set_coordinates(const scene::Vec3* coordinates) noexcept { coordinates_ = coordinates; }
  /// The surface that the point is on; null if it is on none. It belongs to the caller of set_surface.
  [[nodiscard]] const SurfaceView* surface() const noexcept { return surface_; }
  void set_surface(const SurfaceView* surface) noexcept { surface_ = surface; }

 private:
  NoiseGenerator noise_generator_;
  StepCounter steps_;
  const PatternSource* patterns_;
  const scene::Vec3* coordinates_ = nullptr;
  const SurfaceView* surface_ = nullptr;
};

/// Applies one operation on numbers alone (those up to `radians` in scene::Opcode); b is ignored by operations with one
/// operand. Both the machine and the folding of constants use it.
[[nodiscard]] double apply(scene::Opcode operation, double a, double b) noexcept;

/// `frame` has function.frame_size doubles, of which the first hold the arguments; afterwards the first hold the
/// results. Arguments outside a function's domain give the values of IEEE arithmetic: NaN and infinities propagate, and
/// nothing fails.
void evaluate(const scene::Function& function, double* frame, Environment& environment) noexcept;

/// The results; unused terms are zero. `arguments` are as many as the function has parameters.
[[nodiscard]] std::array<double, 5> evaluate(const scene::Function& function, std::span<const double> arguments,
                                             Environment& environment) noexcept;

}  // namespace isl::values
