#include "cli/output/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::cli {
namespace {

constexpr int kBarCells = 40;                           // with its texts narrower than the usual 80 columns
constexpr std::chrono::milliseconds kRedrawEvery{100};  // faster changes cannot be read
constexpr std::chrono::milliseconds kShowAfter{300};    // a bar for a shorter time would only flash
constexpr double kGuessFrom = 0.01;                     // with less done, the time left cannot be estimated

std::string minutes_and_seconds(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string progress_line(double done, std::chrono::duration<double> elapsed) {
  const double fraction = std::clamp(done, 0.0, 1.0);
  const int cells = static_cast<int>(fraction * kBarCells);
  std::string line =
      fmt::format("[{:#<{}}{:.<{}}] {:3} %", "", cells, "", kBarCells - cells, static_cast<int>(fraction * 100));
  if (fraction >= kGuessFrom)
    line += fmt::format("  {} left", minutes_and_seconds(elapsed.count() * (1 - fraction) / fraction));
  return line;
}

void ProgressBar::update(double done) {
  if (terminal_ == nullptr) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);  // tracing never waits for a terminal
  if (!lock.owns_lock()) return;
  const Clock::time_point now = Clock::now();
  if (now - start_ < kShowAfter || now - drawn_ < kRedrawEvery) return;
  drawn_ = now;
  visible_ = true;
  fmt::print(terminal_, "\r{}\x1b[K", progress_line(done, now - start_));
  std::fflush(terminal_);
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  if (!visible_) return;
  visible_ = false;
  fmt::print(terminal_, "\r\x1b[K");
  std::fflush(terminal_);
}

}  // namespace isl::cli
