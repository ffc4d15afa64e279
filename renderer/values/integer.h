// The conversion of numbers to integers in the language: towards zero, into 32 bits, as in POV-Ray.
#pragma once

#include <cstdint>

namespace isl::values {

/// Rounds towards zero. A value that does not fit (NaN too) becomes −2³¹, which is the result on x86 and thus
/// POV-Ray's.
[[nodiscard]] std::int32_t to_integer(double value) noexcept;

}  // namespace isl::values
