// The limits of one run, as every part of the program that may take long or hold much gets them.
#pragma once

#include "base/budget.h"
#include "base/stop_flag.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace isl {

/// The default bound of what one ray takes in one blob: about 10 ms.
inline constexpr std::uint64_t kStepsOfRay = std::uint64_t{1} << 22;

/// Everything pointed to outlives the work. Null: without that limit.
struct RunLimits {
  Budget* budget = nullptr;
  const StopFlag* stop = nullptr;
  /// The greatest number of steps that patterns and functions may take at one point (base/stop_flag.h).
  std::uint64_t steps_at_point = StepCounter::kUnlimited;
  /// The greatest number of steps that one ray may take in one blob (renderer/rays/ray_steps.h).
  std::uint64_t steps_of_ray = kStepsOfRay;
};

/// Tells work on several threads whether it may go on: until the budget does not have what a thread asks for, or the
/// run is stopped. From then on everything is refused, so that all loops end soon. The result is then thrown away.
class Meter {
 public:
  explicit Meter(const RunLimits& run) : run_(run) {}
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  /// A charge for one of the threads.
  [[nodiscard]] Charge new_charge() const { return Charge(run_.budget); }
  /// Called before an allocation: counts the bytes in `charge`. False if the work must end.
  [[nodiscard]] bool grow(Charge& charge, std::size_t bytes) noexcept {
    if (!goes_on()) return false;
    if (charge.grow(bytes)) return true;
    is_refused_.store(true, std::memory_order_relaxed);
    return false;
  }
  [[nodiscard]] bool goes_on() const noexcept { return !is_refused() && !is_set(run_.stop); }
  /// Bytes that can still be had.
  [[nodiscard]] std::size_t left() const noexcept {
    return run_.budget != nullptr ? run_.budget->left() : std::numeric_limits<std::size_t>::max();
  }
  /// True if memory was refused; a run that is stopped refuses nothing.
  [[nodiscard]] bool is_refused() const noexcept { return is_refused_.load(std::memory_order_relaxed); }
  [[nodiscard]] const RunLimits& run() const { return run_; }

 private:
  RunLimits run_;
  std::atomic<bool> is_refused_ = false;
};

}  // namespace isl
