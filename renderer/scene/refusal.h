// The reason why a scene is not drawn, or an object's question not answered, although nothing in the text is wrong: it
// would take more memory or more steps than the run allows. The renderer makes it, and cli or the interpreter turn it
// into a diagnostic.
#pragma once

#include "base/source_span.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace isl::scene {

struct Refusal {
  std::string message;  ///< what was found, and the limit; lower case, without a full stop
  std::string hint;     ///< the option that raises the limit
  OriginId origin{};    ///< the statement at fault; unknown if the command line is
};

/// Keeps the first of the refusals that threads report.
class FirstRefusal {
 public:
  void report(Refusal refusal) {
    const std::lock_guard lock(mutex_);
    if (!refusal_) refusal_ = std::move(refusal);
    is_set_.store(true, std::memory_order_relaxed);
  }
  /// True once a refusal was reported: the rest of the work is in vain.
  [[nodiscard]] bool is_set() const noexcept { return is_set_.load(std::memory_order_relaxed); }
  /// Precondition: no thread reports any more.
  [[nodiscard]] const std::optional<Refusal>& refusal() const { return refusal_; }

 private:
  std::mutex mutex_;
  std::optional<Refusal> refusal_;
  std::atomic<bool> is_set_ = false;
};

}  // namespace isl::scene
