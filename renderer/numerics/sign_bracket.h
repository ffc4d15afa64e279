// Finds the place in a bracket where a function changes sign, to the last digit of its argument or until its value is
// 0.
#pragma once

#include <cmath>

namespace isl::render {

/// The value of a function at t.
struct FunctionAt {
  double t, value;
};

/// Precondition: f has the sign `sign` at `first` or, within rounding, is zero; it has the opposite sign at `last`.
/// Regula falsi that halves the weight of an end that stays (Illinois; Dowell and Jarratt 1971), and halves the bracket
/// whenever three steps have not halved it. It needs at most four times as many evaluations as bisection, usually six
/// in all.
template <class Function>
[[nodiscard]] double root_in_bracket(const Function& f, const FunctionAt& first, const FunctionAt& last, int sign) {
  double low = first.t, high = last.t, f_low = sign * first.value, f_high = sign * last.value;
  if (!(f_low > 0)) return low;
  if (!(f_high < 0)) return high;
  double width = high - low;
  int kept = 0;  // which end stayed in the last step: 1 for the low one, −1 for the high one
  for (int step = 1;; ++step) {
    double middle = low + (high - low) * (f_low / (f_low - f_high));
    if (step % 3 == 0) {
      if (high - low > 0.5 * width) middle = low + 0.5 * (high - low);
      width = high - low;
    }
    if (!(middle > low && middle < high)) {
      middle = low + 0.5 * (high - low);
      if (!(middle > low && middle < high)) return std::abs(f_low) < std::abs(f_high) ? low : high;
    }
    const double value = sign * f(middle);
    if (value > 0) {
      low = middle;
      f_low = value;
      if (kept < 0) f_high *= 0.5;
      kept = -1;
    } else if (value < 0) {
      high = middle;
      f_high = value;
      if (kept > 0) f_low *= 0.5;
      kept = 1;
    } else {
      return middle;  // zero, or NaN
    }
  }
}

}  // namespace isl::render
