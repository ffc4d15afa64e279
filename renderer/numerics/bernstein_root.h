// The root of a polynomial in Bernstein form in a bracket, by Newton's method.
#pragma once

#include "renderer/numerics/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {

/// One step of Newton's method: a number that has the sign of the value, and value/slope.
struct NewtonStep {
  double sign_of_value, step;
};

/// `weighted` is made by with_binomials(). With v = u/(1−u) and Q(v) = Σ wᵢ vⁱ the value is (1−u)ⁿ Q and the slope
/// (1−u)ⁿ⁻² (Q′ − n(1−u) Q); from the other end likewise. So their ratio needs no powers.
template <class Polynomial>
[[nodiscard]] NewtonStep newton_step(const Polynomial& weighted, double u) {
  const int n = weighted.degree;
  double q = 0, slope = 0;
  if (u <= 0.5) {
    const double near = 1 - u, ratio = u / near;
    for (int i = n; i >= 0; --i) {
      slope = slope * ratio + q;
      q = q * ratio + weighted[i];
    }
    return {q, near * near * q / (slope - n * near * q)};
  }
  const double ratio = (1 - u) / u;
  for (int i = 0; i <= n; ++i) {
    slope = slope * ratio + q;
    q = q * ratio + weighted[i];
  }
  return {q, u * u * q / (n * u * q - slope)};
}

/// A Newton step of this share of u is the last.
inline constexpr double kLastDigits = 0x1p-50;
/// Steps this short that do not shrink any more are rounding.
inline constexpr double kFewDigits = 0x1p-30;

/// Precondition: the value at `low` has the sign `sign` or, within rounding, is zero; that at `high` has the opposite
/// sign. Newton steps that stay in the bracket and shrink by half, else halvings of the bracket: usually four of
/// them in all, to the last digit of u or to where rounding moves the value as much as another step would; or until a
/// step within the bracket is at most `enough`.
template <class Polynomial>
[[nodiscard]] double bernstein_root(const Polynomial& weighted, double low, double high, int sign, double enough = 0) {
  const double f_low = sign * value_at(weighted, low), f_high = sign * value_at(weighted, high);
  if (!(f_low > 0)) return low;
  if (!(f_high < 0)) return high;
  double last = std::numeric_limits<double>::infinity();  // the last of consecutive Newton steps
  double u = low + (high - low) * (f_low / (f_low - f_high));
  for (;;) {
    if (!(u > low && u < high)) {
      u = low + 0.5 * (high - low);
      if (!(u > low && u < high)) return u;
    }
    const NewtonStep at = newton_step(weighted, u);
    const double value = sign * at.sign_of_value;
    if (value > 0) {
      low = u;
    } else if (value < 0) {
      high = u;
    } else {
      return u;  // zero, or NaN
    }
    const double size = std::abs(at.step), next = u - at.step;
    const bool is_inside = next > low && next < high;
    if (is_inside && size <= std::max(kLastDigits * u, enough)) return next;
    if (is_inside && size <= 0.5 * last) {
      last = size;
      u = next;
    } else if (last <= kFewDigits * u) {
      return u;
    } else {
      last = std::numeric_limits<double>::infinity();
      u = low + 0.5 * (high - low);
    }
  }
}

}  // namespace isl::render
