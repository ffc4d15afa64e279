// The progress bar of a render, on a terminal only.
#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>

namespace isl::cli {

/// `[######......]  43 %  1:05 left`, redrawn in place. `done` is the fraction from 0 to 1.
[[nodiscard]] std::string progress_line(double done, std::chrono::duration<double> elapsed);

class ProgressBar {
 public:
  /// Draws on `terminal`; nullptr: draws nothing.
  explicit ProgressBar(std::FILE* terminal) : terminal_(terminal), start_(Clock::now()) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// May be called from any thread at any rate: it draws a few times a second.
  void update(double done);

  /// Removes the bar from the screen.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::FILE* terminal_;
  Clock::time_point start_;
  std::mutex mutex_;
  Clock::time_point drawn_{};
  bool visible_ = false;
};

}  // namespace isl::cli
