// The interface of base/parallel.h on plain threads: slower than a scheduler's, and ThreadSanitizer sees all of its
// synchronisation. A loop inside a loop runs on its caller's thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace isl {

namespace plain_threads {
inline thread_local int loop_threads = 0;  ///< 0: not set
}

[[nodiscard]] inline int default_thread_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

template <class Work>
void with_threads(int threads, const Work& work) {
  struct Restore {
    int before;
    ~Restore() { plain_threads::loop_threads = before; }
  } const restore{plain_threads::loop_threads};
  plain_threads::loop_threads = threads;
  work();
}

template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  const int wanted = plain_threads::loop_threads > 0 ? plain_threads::loop_threads : default_thread_count();
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto work = [&] {
    with_threads(1, [&] {
      try {
        for (std::size_t i = next++; i < count; i = next++) body(i);
      } catch (...) {
        next = count;
        const std::lock_guard lock(mutex);
        thrown = std::current_exception();
      }
    });
  };
  std::vector<std::jthread> helpers;
  const std::size_t threads = std::min(static_cast<std::size_t>(wanted), count);
  for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
  work();
  helpers.clear();  // joins them
  if (thrown) std::rethrow_exception(thrown);
}

template <class T>
class PerThread {
 public:
  [[nodiscard]] T& local() {
    const std::lock_guard lock(mutex_);
    return values_[std::this_thread::get_id()];
  }
  template <class Visit>
  void for_each(const Visit& visit) {
    for (auto& [thread, value] : values_) visit(value);
  }

 private:
  std::mutex mutex_;
  std::map<std::thread::id, T> values_;
};

}  // namespace isl
