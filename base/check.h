// Checks for bugs of the program itself. A user's mistake is never one of these: it is a Diagnostic.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace isl {

/// Prints the place and the reason, then aborts: a broken invariant must not produce a picture.
[[noreturn]] inline void check_failed(const char* file, int line, const char* condition, const std::string& values) {
  std::fputs(fmt::format("isl: internal error at {}:{}: {} does not hold{}{}\n", file, line, condition,
                         values.empty() ? "" : ": ", values)
                 .c_str(),
             stderr);
  std::abort();
}

}  // namespace isl

/// ISL_CHECK(condition) or ISL_CHECK(condition, "format {}", values…): checked in every build.
#define ISL_CHECK(condition, ...)                                                         \
  do {                                                                                    \
    if (!(condition)) [[unlikely]]                                                        \
      ::isl::check_failed(__FILE__, __LINE__, #condition, ::fmt::format("" __VA_ARGS__)); \
  } while (false)

/// The same check, compiled only without NDEBUG; for inner loops.
#ifdef NDEBUG
#define ISL_DCHECK(condition, ...) static_cast<void>(0)
#else
#define ISL_DCHECK(condition, ...) ISL_CHECK(condition __VA_OPT__(, ) __VA_ARGS__)
#endif
