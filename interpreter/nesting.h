// The depth limit of the evaluator's own recursion, and the stack that it takes. Depth is counted, never probed: every
// function that may call itself passes a NestingGuard, and the thread that evaluates gets a stack large enough for the
// count.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Stack that one unit may take. Measured (tests/interpreter/depth_test.cpp drives the limit on every kind of
/// recursion): a nested expression takes some 300 bytes and counts 1, a reader with its stream some 3 kB and counts
/// kStreamUnits.
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
inline constexpr std::size_t kNestingBytes = 4096;
#else
inline constexpr std::size_t kNestingBytes = 1024;
#endif
inline constexpr std::size_t kStreamUnits = 8;

/// Enough for every macro call or block to hold a stream and an expression 16 operators deep.
[[nodiscard]] constexpr std::size_t max_nesting(const Limits& limits) {
  return limits.max_depth * (kStreamUnits + 16) + 2000;
}

/// Bytes of stack for an evaluation within `limits`.
[[nodiscard]] constexpr std::size_t stack_bytes(const Limits& limits) {
  return max_nesting(limits) * kNestingBytes + (std::size_t{1} << 20);
}

/// Counts one step of native recursion during its lifetime.
class NestingGuard {
 public:
  NestingGuard(Context& context, SourceSpan span, std::size_t units = 1) : context_(context), units_(units) {
    context_.nest(span, units_);
  }
  ~NestingGuard() { context_.unnest(units_); }
  NestingGuard(const NestingGuard&) = delete;
  NestingGuard& operator=(const NestingGuard&) = delete;

 private:
  Context& context_;
  std::size_t units_;
};

}  // namespace isl::interpreter
