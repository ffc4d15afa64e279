#include "renderer/patterns/fractal_patterns.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

using scene::FractalOperands;

/// Of complex numbers, written out: std::complex looks for infinities in every product.
struct Complex {
  double re = 0, im = 0;
  friend Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
  friend Complex operator/(Complex a, Complex b) {
    const double d = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
  }
  [[nodiscard]] double norm() const { return re * re + im * im; }
};

constexpr double kBailout = 4, kMagnetBailout = 10000, kMagnetGoal = 1 / 10000.0;  ///< of squared distances

Complex power(Complex z, int exponent) {
  Complex result = z;
  for (int i = 1; i < exponent; ++i) result = result * z;
  return result;
}

/// One step from z, and whether the orbit has then escaped.
struct PowerStep {
  Complex c;
  int exponent;
  [[nodiscard]] Complex next(Complex z) const { return power(z, exponent) + c; }
  [[nodiscard]] static bool has_ended(Complex z) { return z.norm() > kBailout; }
};

/// z ↦ ((z² + c − 1) / (2z + c − 2))²; orbits end at infinity or at 1.
struct Magnet1Step {
  Complex c;
  [[nodiscard]] Complex next(Complex z) const {
    const Complex quotient = (z * z + c - Complex{1, 0}) / (z + z + c - Complex{2, 0});
    return quotient * quotient;
  }
  [[nodiscard]] static bool has_ended(Complex z) {
    return z.norm() > kMagnetBailout || (z - Complex{1, 0}).norm() < kMagnetGoal;
  }
};

/// z ↦ ((z³ + 3(c − 1)z + (c − 1)(c − 2)) / (3z² + 3(c − 2)z + (c − 1)(c − 2) + 1))².
struct Magnet2Step {
  Complex c1, c2, c12;  ///< c − 1, c − 2, and their product
  explicit Magnet2Step(Complex c) : c1(c - Complex{1, 0}), c2(c - Complex{2, 0}), c12(c1 * c2) {}
  [[nodiscard]] Complex next(Complex z) const {
    const Complex three{3, 0};
    const Complex quotient =
        (z * z * z + three * c1 * z + c12) / (three * z * z + three * c2 * z + c12 + Complex{1, 0});
    return quotient * quotient;
  }
  [[nodiscard]] static bool has_ended(Complex z) { return Magnet1Step::has_ended(z); }
};

/// The colouring of what the orbit came to; `iterations` after which it ended.
double exterior(const FractalOperands& o, double iterations, Complex z) {
  const double factor = o.exterior_factor;
  switch (o.exterior_type) {
    case 0: return factor;
    case 1: return iterations / o.iterations;
    case 2: return z.re * factor;
    case 3: return z.im * factor;
    case 4: return z.re * z.re * factor;
    case 5: return z.im * z.im * factor;
    default: return std::sqrt(z.norm()) * factor;
  }
}

double interior(const FractalOperands& o, Complex z, double least_norm) {
  const double factor = o.interior_factor;
  switch (o.interior_type) {
    case 0: return factor;
    case 1: return std::sqrt(least_norm) * factor;
    case 2: return z.re * factor;
    case 3: return z.im * factor;
    case 4: return z.re * z.re * factor;
    case 5: return z.im * z.im * factor;
    default: return z.re * z.re + z.im * z.im * factor;  // as POV-Ray has it: no root, and the factor in one term
  }
}

template <class Step>
double orbit(const FractalOperands& o, Complex z, double least_norm, const Step& step) {
  for (double i = 0; i < o.iterations; ++i) {
    z = step.next(z);
    least_norm = std::min(least_norm, z.norm());
    if (step.has_ended(z)) return exterior(o, i, z);
  }
  return interior(o, z, least_norm);
}

}  // namespace

double fractal(const scene::Vec3& p, const FractalOperands& o) noexcept {
  const Complex point{p.x, p.y};
  const Complex c = o.is_julia ? Complex{o.real, o.imaginary} : point;
  if (o.magnet == 0) return orbit(o, point, point.norm(), PowerStep{c, o.exponent});
  // The start of a magnet's Mandelbrot set is 0 and does not count as near to it.
  const Complex start = o.is_julia ? point : Complex{0, 0};
  const double least_norm = o.is_julia ? point.norm() : kMagnetBailout;
  return o.magnet == 1 ? orbit(o, start, least_norm, Magnet1Step{c}) : orbit(o, start, least_norm, Magnet2Step(c));
}

}  // namespace isl::render
