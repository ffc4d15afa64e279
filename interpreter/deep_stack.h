// Runs a function on a stack of a given size, so that counted recursion (interpreter/nesting.h) cannot overflow what
// the caller's thread happens to have.
#pragma once

#include <cstddef>
#include <functional>

namespace isl::interpreter {

/// Calls `function` on a thread of its own and waits for it. False where there is no memory for such a stack; then it
/// did not run. The function lets no exception out.
[[nodiscard]] bool run_on_stack(std::size_t bytes, const std::function<void()>& function);

}  // namespace isl::interpreter
