// Finds the one place between two numbers where a condition stops holding, by halving. Serves for constants of kernels,
// once for each kernel.
#pragma once

namespace isl::render {

/// The greatest x found for which `holds` is true. Precondition: `holds` is true from `low` up to some place and false
/// from there to `high`. After 64 halvings, an interval of ordinary size is shorter than a rounding.
template <class Condition>
[[nodiscard]] double last_where(const Condition& holds, double low, double high) {
  for (int step = 0; step < 64; ++step) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace isl::render
