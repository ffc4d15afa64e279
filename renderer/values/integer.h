// Whole numbers: the conversion of numbers to integers in the language (towards zero, into 32 bits, as in POV-Ray), and
// parity.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace isl::values {

/// Rounds towards zero. A value that does not fit (NaN too) becomes −2³¹, which is the result on x86 and thus
/// POV-Ray's.
[[nodiscard]] inline std::int32_t to_integer(double value) noexcept {
  if (value > -2147483649.0 && value < 2147483648.0) return static_cast<std::int32_t>(value);
  return std::numeric_limits<std::int32_t>::min();
}

/// For whole numbers of any size; their halves are exact.
[[nodiscard]] inline bool is_odd(double whole) noexcept { return whole * 0.5 != std::floor(whole * 0.5); }

}  // namespace isl::values
