// A number rounded to single precision and kept as a double, where POV-Ray stores a float.
#pragma once

namespace isl::values {

/// `value` rounded to the nearest float. The way through `volatile` is needed: GCC 12 at -O2, turning two such
/// neighbours into a vector, drops both conversions, and the result then depends on the optimiser.
[[nodiscard]] inline double to_single(double value) noexcept {
  const volatile float single = static_cast<float>(value);
  return static_cast<double>(single);
}

}  // namespace isl::values
