// Reports how much of a rendering is done.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace isl::render {

/// Counts work units from many threads. A report that would have to wait for another thread's is dropped, because the
/// next one says more.
class Progress {
 public:
  explicit Progress(std::function<void(double)> tell) : tell_(std::move(tell)) {}

  /// Begins a stage that takes the share done from where it is to `end`, in `units` steps.
  void begin_stage(double end, std::size_t units) {
    start_ = end_;
    end_ = end;
    units_ = units;
    done_ = 0;
  }

  /// Counts one unit as done. Any thread may call it.
  void step() {
    const std::size_t done = done_.fetch_add(1) + 1;
    report(start_ + (end_ - start_) * static_cast<double>(done) / static_cast<double>(units_));
  }

  /// The share done. No thread counts units meanwhile.
  [[nodiscard]] double share() const {
    return units_ == 0 ? end_ : start_ + (end_ - start_) * static_cast<double>(done_) / static_cast<double>(units_);
  }

  /// Reports that everything is done. One thread calls it, after the others.
  void finish() { report(1); }

 private:
  void report(double share) {
    if (!tell_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || share <= told_) return;
    told_ = share;
    tell_(share);
  }

  std::function<void(double)> tell_;
  std::mutex mutex_;
  std::atomic<std::size_t> done_ = 0;
  std::size_t units_ = 0;
  double start_ = 0, end_ = 0;
  double told_ = 0;
};

}  // namespace isl::render
