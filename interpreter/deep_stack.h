// Runs a function on a stack of a given size, so that counted recursion (interpreter/nesting.h) cannot overflow the
// smaller stack of the caller's thread.
#pragma once

#include <cstddef>
#include <functional>

namespace isl::interpreter {

/// Calls `function` on a thread of its own and waits for it. Returns false, without calling it, if there is no memory
/// for such a stack. The function must not throw.
[[nodiscard]] bool run_on_stack(std::size_t bytes, const std::function<void()>& function);

}  // namespace isl::interpreter
