// How numbers become integers in the language: towards zero, into 32 bits, as POV-Ray has it.
#pragma once

#include <cstdint>

namespace isl::values {

/// Rounds towards zero; what does not fit (NaN too) becomes −2³¹, which is what x86 makes of it and thus POV-Ray's
/// answer.
[[nodiscard]] std::int32_t to_integer(double value) noexcept;

}  // namespace isl::values
