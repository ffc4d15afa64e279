// How long work is ended early: a flag that a signal or a clock sets, and a count of steps that looks at it. Whatever
// may take longer than a tenth of a second looks at the flag.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

namespace isl {

enum class StopReason : std::uint8_t {
  none,
  interrupt,  ///< Ctrl-C
  ended,      ///< the system or a queue ends the process: SIGTERM or SIGHUP
  time_over,  ///< --max-time
};

/// Set once, from any thread or a signal handler; looked at by everything that takes long.
class StopFlag {
 public:
  /// The first reason stays. Returns false if there was one.
  bool set(StopReason reason) noexcept {
    StopReason none = StopReason::none;
    return reason_.compare_exchange_strong(none, reason, std::memory_order_relaxed);
  }
  [[nodiscard]] bool is_set() const noexcept { return reason() != StopReason::none; }
  [[nodiscard]] StopReason reason() const noexcept { return reason_.load(std::memory_order_relaxed); }

 private:
  std::atomic<StopReason> reason_ = StopReason::none;
  static_assert(std::atomic<StopReason>::is_always_lock_free, "a signal handler may not wait for a lock");
};

/// True if work that has this flag, or none, is to end.
[[nodiscard]] inline bool is_set(const StopFlag* stop) noexcept { return stop != nullptr && stop->is_set(); }

/// Counts the steps of one piece of work against a limit, and looks at a flag once in kStepsBetweenLooks.
class StepCounter {
 public:
  /// A step is a turn of a loop, a call, or one evaluation of a pattern: at most some ten microseconds, so that the
  /// flag is seen within a twentieth of a second.
  static constexpr std::uint64_t kStepsBetweenLooks = 4096;
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

  explicit StepCounter(std::uint64_t limit = kUnlimited, const StopFlag* stop = nullptr) : left_(limit), stop_(stop) {}

  /// Counts one step. False if the work must end: see is_spent().
  [[nodiscard]] bool take() noexcept {
    if (until_look_ == 0) [[unlikely]]
      return look();
    --until_look_;
    return true;
  }
  /// Counts several steps: the turns of a loop that cannot end between two of them.
  [[nodiscard]] bool take(std::uint64_t steps) noexcept {
    for (; steps > until_look_; --steps) {
      steps -= until_look_;
      if (!look()) return false;
    }
    until_look_ -= steps;
    return true;
  }
  /// Lets no further step be taken.
  void spend() noexcept {
    until_look_ = left_ = 0;
    is_spent_ = true;
  }

  /// Steps that may still be taken.
  [[nodiscard]] std::uint64_t left() const noexcept { return left_ + until_look_; }

  /// True once a step was refused, because the limit was reached or the flag was set.
  [[nodiscard]] bool is_spent() const noexcept { return is_spent_; }

 private:
  bool look() noexcept {
    if (left_ == 0 || is_set(stop_)) {
      spend();
      return false;
    }
    const std::uint64_t next = std::min(left_, kStepsBetweenLooks);
    left_ -= next;
    until_look_ = next - 1;
    return true;
  }

  std::uint64_t until_look_ = 0;
  std::uint64_t left_;  ///< steps beyond those
  const StopFlag* stop_;
  bool is_spent_ = false;
};

}  // namespace isl
