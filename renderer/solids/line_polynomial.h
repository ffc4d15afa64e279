// A polynomial in three variables along a line, as one of a single variable s in [−1, 1]:
//
//      P̂(centre + s·half, w) = Σ aₖ sᵏ,    P made homogeneous: P̂(x, y, z, w) = wⁿ P(x/w, y/w, z/w)
//
// Horner's rule for three variables, on sums Σ aₖ sᵏ: it needs products with linear forms. A term's missing order is
// made up for by a power of w. Rounding is bounded by Horner's rule with absolute values at |centre| + |half|, which is
// the largest that coordinates are on the line's part.
//
// The Bernstein coefficients on [−1, 1] are sums of the aₖ times numbers of at most 1: with s = u − ū and 1 = u + ū,
// those of (u − ū)ᵏ (u + ū)ⁿ⁻ᵏ are at most those of (u + ū)ⁿ. So what rounding moves the aₖ by is all that it moves
// these by. The same holds beyond ±1 for the polynomial in 1/s.
#pragma once

#include "renderer/numerics/bernstein.h"
#include "renderer/solids/solid_details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace isl::render {

/// The points centre + s·half with the same w.
struct LinePart {
  Vec3 centre, half;
  double w;
};

/// How much larger than on the pieces of a whole line coordinates may be on a stretch that is followed alone: n bits of
/// 2ⁿ are lost.
inline constexpr double kMostStretchGrowth = 2;

/// Bound of the rounding of Bernstein coefficients of this order, relative to largest_terms(). A term passes through at
/// most n products with linear forms (each 3 roundings in two coefficients) and as many sums, 3n + 1 roundings on the
/// way to Bernstein's form, and n cuts of 3; halvings (polynomial_roots.h) add no more than n. 11(n + 2) units of 2⁻⁵³
/// bound them all.
[[nodiscard]] inline double rounding_on_line(int order) { return 11 * (order + 2) * 0x1p-53; }

/// P̂ with all terms as positive, at the largest coordinates of the part.
[[nodiscard]] inline double largest_terms(const PreparedPolynomial& polynomial, const LinePart& part) {
  const auto largest = [&](int i) { return std::abs(part.centre[i]) + std::abs(part.half[i]); };
  const double x = largest(0), y = largest(1), z = largest(2);
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0;
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0;
    for (int j = 0; j <= i; ++j) {
      double in_z = 0, power = 1;
      for (int k = 0; k <= j; ++k) {
        in_z = in_z * z + std::abs(*coefficient++) * power;
        power *= part.w;
      }
      in_y = in_y * y + in_z;
    }
    in_x = in_x * x + in_y;
  }
  return in_x;
}

/// Polynomials of one variable by their coefficients, here of powers. Types are those of the Bernstein form; the degree
/// is that of P.
template <class Coefficients>
class PowerForm {
 public:
  PowerForm(const PreparedPolynomial& polynomial, const LinePart& part) {
    const int n = degree_of(polynomial);
    std::array<double, kMost + 1> powers_of_w;
    powers_of_w[0] = 1;
    for (int k = 1; k <= n; ++k) powers_of_w[at(k)] = powers_of_w[at(k - 1)] * part.w;
    const double* coefficient = polynomial.coefficients.data();
    Sum in_x;
    for (int i = 0; i <= n; ++i) {
      Sum in_y;
      for (int j = 0; j <= i; ++j) {
        Sum in_z;
        for (int k = 0; k <= j; ++k) {
          in_z.multiply(part.centre.z, part.half.z);
          if (const double c = *coefficient++; c != 0) in_z.add(c * powers_of_w[at(k)]);
        }
        in_y.multiply(part.centre.y, part.half.y);
        in_y.add(in_z);
      }
      in_x.multiply(part.centre.x, part.half.x);
      in_x.add(in_y);
    }
    in_x.lengthen(n);
    if constexpr (!kIsFixed) a_.degree = n;
    for (int k = 0; k <= n; ++k) a_[k] = in_x.c[at(k)];
  }

  /// The Bernstein coefficients for s from −1 to 1.
  [[nodiscard]] Coefficients on_part() const {
    Coefficients b = a_;
    const int n = b.degree;
    b[0] = a_[n];
    for (int m = 1; m <= n; ++m) {
      // Horner's rule: b becomes b·(u − ū) + a·(u + ū)ᵐ.
      const double a = a_[n - m];
      b[m] = b[m - 1] + a;
      for (int i = m - 1; i > 0; --i) b[i] = b[i - 1] - b[i] + a * binomial(m, i);
      b[0] = a - b[0];
    }
    for (int i = 1; i < n; ++i) b[i] /= binomial(n, i);
    return b;
  }
  /// The Bernstein coefficients of uⁿ Σ aₖ (sign/u)ᵏ for u from 0 to 1.
  [[nodiscard]] Coefficients from_infinity(double sign) const {
    Coefficients b = a_;
    const int n = b.degree;
    for (int k = 0; k <= n; ++k) b[n - k] = sign < 0 && k % 2 != 0 ? -a_[k] : a_[k];
    to_bernstein(b);
    return b;
  }

 private:
  static constexpr int kMost = static_cast<int>(std::tuple_size_v<decltype(Coefficients::b)>) - 1;
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// A degree that the compiler knows: then all sums have its length, so that no loop counts.
  static constexpr bool kIsFixed = !std::is_same_v<Coefficients, Bernstein>;
  [[nodiscard]] static int degree_of(const PreparedPolynomial& polynomial) {
    return kIsFixed ? kMost : polynomial.order;
  }

  /// A sum of powers that knows whether it is zero: most coefficients of usual polynomials are. All loops have constant
  /// ends, so that its numbers stay in registers.
  struct FixedSum {
    bool is_zero = true;
    std::array<double, kMost + 1> c{};

    void multiply(double constant, double slope) {
      if (is_zero) return;
#pragma GCC unroll 8
      for (int k = kMost; k > 0; --k) c[at(k)] = constant * c[at(k)] + slope * c[at(k - 1)];
      c[0] *= constant;
    }
    void add(double value) {
      c[0] += value;
      is_zero = false;
    }
    void add(const FixedSum& other) {
      if (other.is_zero) return;
#pragma GCC unroll 8
      for (int k = 0; k <= kMost; ++k) c[at(k)] += other.c[at(k)];
      is_zero = false;
    }
    void lengthen(int) {}
  };
  /// The same with as many powers as it has come to have.
  struct GrowingSum {
    int degree = -1;  ///< of zero
    std::array<double, kMost + 1> c;

    void multiply(double constant, double slope) {
      if (degree < 0) return;
      c[at(++degree)] = 0;
      for (int k = degree; k > 0; --k) c[at(k)] = constant * c[at(k)] + slope * c[at(k - 1)];
      c[0] *= constant;
    }
    void add(double value) {
      lengthen(0);
      c[0] += value;
    }
    void add(const GrowingSum& other) {
      lengthen(other.degree);
      for (int k = 0; k <= other.degree; ++k) c[at(k)] += other.c[at(k)];
    }
    void lengthen(int to) {
      while (degree < to) c[at(++degree)] = 0;
    }
  };
  using Sum = std::conditional_t<kIsFixed, FixedSum, GrowingSum>;

  /// bᵢ = Σ C(i,k)/C(n,k) aₖ: Pascal's triangle.
  static void to_bernstein(Coefficients& p) {
    const int n = p.degree;
    for (int k = 1; k < n; ++k) p[k] /= binomial(n, k);
    for (int row = 1; row <= n; ++row) {
      for (int i = n; i >= row; --i) p[i] += p[i - 1];
    }
  }

  Coefficients a_;
};

}  // namespace isl::render
