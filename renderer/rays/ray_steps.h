// The bound of what one ray may take in one blob. It is counted in steps, not in time, so that a ray ends at the same
// place on every machine.
#pragma once

#include "base/run_limits.h"
#include "base/stop_flag.h"

#include <algorithm>
#include <cstdint>

namespace isl::render {

// A step is the evaluation of one component's field in double precision. Other work counts as many steps as it takes
// times as long, as measured on fields of all kinds.

/// To split an interval and judge its halves: for itself, and for each row of eight fields of one kind, of which value,
/// slope and bounds are found side by side.
inline constexpr std::uint64_t kStepsOfInterval = 32, kStepsOfRow = 128;
/// To evaluate one component's field with more digits (renderer/extended).
inline constexpr std::uint64_t kStepsOfLongDouble = 512;
/// With 113 bits. It takes eight times as long as that, but what is asked there nothing else decides: at the full price
/// thirty of 300,000 rays through blobs whose detail is down to 10⁻¹⁵ of their extent would end undecided.
inline constexpr std::uint64_t kStepsOfWide = 2048;

/// Counts the steps of one ray in one blob.
class RaySteps {
 public:
  explicit RaySteps(std::uint64_t most = kStepsOfRay, const StopFlag* stop = nullptr)
      : most_(most), stop_(stop), counter_(most, stop) {}

  /// False if the search must end, because it has taken its steps or the run is stopped.
  [[nodiscard]] bool take(std::uint64_t steps) noexcept { return counter_.take(steps); }
  /// True once a step was refused.
  [[nodiscard]] bool is_spent() const noexcept { return counter_.is_spent(); }
  [[nodiscard]] std::uint64_t taken() const noexcept { return most_ - counter_.left(); }
  /// A count of its own for a part of the work that may take so many, and what it took.
  [[nodiscard]] RaySteps part(std::uint64_t most) const { return RaySteps(std::min(most, counter_.left()), stop_); }
  void add(const RaySteps& part) noexcept { static_cast<void>(take(part.taken())); }
  /// True if more than a tenth of the bound is taken.
  [[nodiscard]] bool are_many() const noexcept { return taken() > most_ / 10; }

 private:
  std::uint64_t most_;
  const StopFlag* stop_;
  StepCounter counter_;
};

}  // namespace isl::render
