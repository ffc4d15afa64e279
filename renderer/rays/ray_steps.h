// The bound of what one ray may take in one blob. It is counted in steps, not in time, so that a ray ends at the same
// place on every machine.
#pragma once

#include "base/run_limits.h"
#include "base/stop_flag.h"

#include <cstdint>

namespace isl::render {

// A step is the evaluation of one component's field in double precision. Other work counts as many steps as it takes
// times as long, as measured on fields of all kinds.

/// To judge an interval, besides evaluating its fields.
inline constexpr std::uint64_t kStepsOfInterval = 16;
/// To evaluate one component's field with more digits (renderer/extended).
inline constexpr std::uint64_t kStepsOfLongDouble = 128;
inline constexpr std::uint64_t kStepsOfWide = 2048;

/// Counts the steps of one ray in one blob.
class RaySteps {
 public:
  explicit RaySteps(std::uint64_t most = kStepsOfRay, const StopFlag* stop = nullptr)
      : most_(most), counter_(most, stop) {}

  /// False if the search must end, because it has taken its steps or the run is stopped.
  [[nodiscard]] bool take(std::uint64_t steps) noexcept { return counter_.take(steps); }
  /// True once a step was refused.
  [[nodiscard]] bool is_spent() const noexcept { return counter_.is_spent(); }
  [[nodiscard]] std::uint64_t taken() const noexcept { return most_ - counter_.left(); }
  /// True if more than a tenth of the bound is taken.
  [[nodiscard]] bool are_many() const noexcept { return taken() > most_ / 10; }

 private:
  std::uint64_t most_;
  StepCounter counter_;
};

}  // namespace isl::render
