// Loops on several threads: the one place that knows who runs them, which is oneTBB. Built for ThreadSanitizer, which
// sees nothing of the synchronisation inside a library that was built without it, the same loops run on plain threads
// (base/plain_threads.h), so that what it reports is ours.
#pragma once

#ifdef __SANITIZE_THREAD__
#include "base/plain_threads.h"
#else

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace isl {

/// How many threads loops run on where nobody says.
[[nodiscard]] inline int default_thread_count() { return tbb::info::default_concurrency(); }

/// Calls `work`, whose loops run on `threads` threads, this one included.
template <class Work>
void with_threads(int threads, const Work& work) {
  // The arena says how many work here; the global limit must allow more than there are cores, if that many were asked
  // for.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute(work);
}

/// Calls `body(i)` for i in [0, count), in any order and at the same time; each call is a task of its own. What a call
/// throws ends the loop and is thrown here.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
      },
      tbb::simple_partitioner{});
}

/// A T for each thread that has asked for one.
template <class T>
class PerThread {
 public:
  [[nodiscard]] T& local() { return values_.local(); }
  /// Calls `visit` with every thread's; no loop may be running.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (T& value : values_) visit(value);
  }

 private:
  tbb::enumerable_thread_specific<T> values_;
};

}  // namespace isl

#endif
