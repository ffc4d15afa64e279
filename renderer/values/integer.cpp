#include "renderer/values/integer.h"

#include <limits>

namespace isl::values {

std::int32_t to_integer(double value) noexcept {
  if (value > -2147483649.0 && value < 2147483648.0) return static_cast<std::int32_t>(value);
  return std::numeric_limits<std::int32_t>::min();
}

}  // namespace isl::values
