// Polynomials in Bernstein form on [0, 1]: Σ bᵢ C(n,i) uⁱ (1−u)ⁿ⁻ⁱ. In this form a polynomial's values lie between its
// coefficients, and its roots move least when the coefficients are rounded (Farouki and Rajan 1987).
#pragma once

#include <array>
#include <cstddef>

namespace isl::render {

/// The greatest order of a `poly` in POV-Ray.
inline constexpr int kMostDegree = 35;

/// A polynomial of a degree up to `most`: searches copy polynomials often, and so prefer small ones.
template <int most>
struct BernsteinUpTo {
  int degree;                      // left uninitialised, because stacks of these are made for every ray
  std::array<double, most + 1> b;  ///< only the first degree + 1 are used

  double& operator[](int i) { return b[static_cast<std::size_t>(i)]; }
  double operator[](int i) const { return b[static_cast<std::size_t>(i)]; }
};
using Bernstein = BernsteinUpTo<kMostDegree>;

/// The same of a degree that the compiler knows, so that its loops are none.
template <int n>
struct FixedBernstein {
  static constexpr int degree = n;
  std::array<double, n + 1> b;

  double& operator[](int i) { return b[static_cast<std::size_t>(i)]; }
  double operator[](int i) const { return b[static_cast<std::size_t>(i)]; }
};

/// Binomial coefficients, exact: C(35, 17) is below 2³³.
[[nodiscard]] inline double binomial(int n, int i) {
  static constexpr auto kRows = [] {
    std::array<std::array<double, kMostDegree + 1>, kMostDegree + 1> rows{};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      rows[row][0] = 1;
      for (std::size_t k = 1; k <= row; ++k) rows[row][k] = rows[row - 1][k - 1] + (k < row ? rows[row - 1][k] : 0);
    }
    return rows;
  }();
  return kRows[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)];
}

/// bᵢ C(n,i), for many values of one polynomial.
template <class Polynomial>
[[nodiscard]] Polynomial with_binomials(const Polynomial& p) {
  Polynomial weighted = p;
  for (int i = 0; i <= p.degree; ++i) weighted[i] = binomial(p.degree, i) * p[i];
  return weighted;
}

/// The value at u in [0, 1] of the polynomial that `weighted` was made of, by Horner's rule in u/(1−u) from the nearer
/// end: all terms are products of numbers in [0, 1] with coefficients, so the rounding is below 2n units of the
/// largest.
template <class Polynomial>
[[nodiscard]] double value_at(const Polynomial& weighted, double u) {
  const int n = weighted.degree;
  double sum = 0, scale = 1;
  if (u <= 0.5) {
    const double near = 1 - u, ratio = u / near;
    for (int i = n; i > 0; --i) {
      sum = sum * ratio + weighted[i];
      scale *= near;
    }
    return (sum * ratio + weighted[0]) * scale;
  }
  const double ratio = (1 - u) / u;
  for (int i = 0; i < n; ++i) {
    sum = sum * ratio + weighted[i];
    scale *= u;
  }
  return (sum * ratio + weighted[n]) * scale;
}

/// Splits at ½ (de Casteljau): `p` becomes the left half, `right`, of the same degree, the right one.
template <class Polynomial>
void halve(Polynomial& p, Polynomial& right) {
  const int n = p.degree;
  right[n] = p[n];
  for (int level = 1; level <= n; ++level) {
    for (int i = n; i >= level; --i) p[i] = 0.5 * (p[i - 1] + p[i]);
    right[n - level] = p[n];
  }
}

/// Divides a polynomial with b₀ = 0 by u. The quotient has one degree less: cᵢ = n/(i+1) bᵢ₊₁.
[[nodiscard]] inline Bernstein over_u(const Bernstein& p) {
  Bernstein quotient;
  quotient.degree = p.degree - 1;
  for (int i = 0; i < p.degree; ++i) quotient[i] = p[i + 1] * p.degree / (i + 1);
  return quotient;
}
template <int n>
[[nodiscard]] FixedBernstein<n - 1> over_u(const FixedBernstein<n>& p) {
  FixedBernstein<n - 1> quotient;
  for (int i = 0; i < n; ++i) quotient[i] = p[i + 1] * n / (i + 1);
  return quotient;
}

}  // namespace isl::render
