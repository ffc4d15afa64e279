// A number rounded to single precision and kept as a double, where POV-Ray stores a float.
#pragma once

namespace isl::values {

/// `value` rounded to the nearest float. The empty statement hides the float from the optimiser: GCC 12 at -O2, turning
/// two such neighbours into a vector, drops both conversions otherwise, and the result then depends on the optimiser.
[[nodiscard]] inline double to_single(double value) noexcept {
  auto single = static_cast<float>(value);
#ifdef __SSE2__
  asm("" : "+x"(single));
#else
  const volatile float stored = single;
  single = stored;
#endif
  return static_cast<double>(single);
}

}  // namespace isl::values
