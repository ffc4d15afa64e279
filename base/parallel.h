// Parallel loops: the one place that knows their scheduler, which is oneTBB. A build for ThreadSanitizer runs the same
// loops on plain threads (base/plain_threads.h): it cannot see the synchronisation inside a library that was built
// without it, and would report false races.
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
#include <utility>

namespace isl {

/// Default number of threads.
[[nodiscard]] inline int default_thread_count() { return tbb::info::default_concurrency(); }

/// True while the calling thread runs its loops without the scheduler. Starting the scheduler takes 0.4 ms, in which a
/// small picture of a plain scene has a fiftieth of its rays traced.
inline thread_local bool is_alone = false;

/// Calls `work`, whose loops run on `threads` threads, the calling one included.
template <class Work>
void with_threads(int threads, const Work& work) {
  if (threads == 1) {
    struct Alone {
      bool before = std::exchange(is_alone, true);
      ~Alone() { is_alone = before; }
    } const alone;
    return work();
  }
  // The arena sets how many threads work here; the global limit must allow more threads than cores, if that many were
  // asked for.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute(work);
}

/// Calls `body(i)` for i in [0, count), in any order and concurrently; each call is a task of its own. An exception of
/// a call ends the loop and is thrown here.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  if (is_alone || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
      },
      tbb::simple_partitioner{});
}

/// One T for each thread that has asked for it.
template <class T>
class PerThread {
 public:
  [[nodiscard]] T& local() { return values_.local(); }
  /// Calls `visit` with the T of every thread; no loop may be running.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (T& value : values_) visit(value);
  }

 private:
  tbb::enumerable_thread_specific<T> values_;
};

}  // namespace isl

#endif
