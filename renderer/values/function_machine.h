// Runs a scene::Function: called by the interpreter where a scene calls one, and by the renderer for every point at
// which a pattern or a surface asks. Knows no text and no names. Nothing is allocated: the caller's frame of doubles
// holds arguments, intermediate values, results, and the frames of the functions that are called.
#pragma once

#include "renderer/scene/function.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace isl::values {

/// Bounds the turns of `sum` and `prod` and the calls within one evaluation. When it is spent, what is left to do is
/// skipped and the result means nothing.
class Budget {
 public:
  explicit Budget(std::uint64_t steps = std::numeric_limits<std::uint64_t>::max()) : steps_(steps) {}
  /// One more turn or call; false where there is none left.
  [[nodiscard]] bool take() noexcept {
    if (steps_ == 0) return false;
    --steps_;
    return true;
  }
  [[nodiscard]] bool is_spent() const noexcept { return steps_ == 0; }

 private:
  std::uint64_t steps_;
};

/// One operation on numbers alone (those up to `radians` in scene::Operation); b is ignored where it takes one.
/// What the machine itself runs, and what folds constants.
[[nodiscard]] double apply(scene::Operation operation, double a, double b) noexcept;

/// `frame` has function.frame_size doubles, of which the first hold the arguments; afterwards the first hold the
/// results. Arguments outside of a domain give what IEEE arithmetic gives: NaN and infinities travel on, nothing fails.
void evaluate(const scene::Function& function, double* frame, Budget& budget) noexcept;

/// The results, the rest zero. `arguments` are as many as the function has parameters.
[[nodiscard]] std::array<double, 5> evaluate(const scene::Function& function, std::span<const double> arguments,
                                             Budget& budget) noexcept;

}  // namespace isl::values
