// Escape-time fractals in the plane of x and y: Mandelbrot and Julia sets of any power, and the magnets (Peitgen,
// Richter, "The Beauty of Fractals", 1986).
#include "renderer/patterns/kinds/pattern_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

namespace isl::render {
namespace {

/// z ↦ z^exponent + c or a magnet of type 1 or 2, from z = 0 (mandel) or the point (julia).
struct Fractal {
  bool is_julia = false;
  int magnet = 0;                  ///< 0: none
  double real = 0, imaginary = 0;  ///< c of a Julia set
  double iterations = 0;
  int exponent = 2;
  int exterior_type = 1;
  double exterior_factor = 1;
  int interior_type = 0;
  double interior_factor = 1;
};

/// Two numbers at once. Orbits are chains of operations that wait for one another, so that two of them side by side
/// take little longer than one, and each step gives the bits that it gives alone.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
using PairMask = decltype(Pair{} < Pair{});

template <class Real>
constexpr std::size_t kOrbits = sizeof(Real) / sizeof(double);
/// The number, or the result of a comparison, of orbit i.
double lane(double x, std::size_t /*i*/) { return x; }
double lane(Pair x, std::size_t i) { return x[i]; }
bool lane(bool x, std::size_t /*i*/) { return x; }
bool lane(PairMask x, std::size_t i) { return x[i] != 0; }

bool either(bool a, bool b) { return a || b; }
PairMask either(PairMask a, PairMask b) { return a | b; }

/// A complex number, with its products written out: std::complex looks for infinities in each of them.
template <class Real>
struct Complex {
  Real re{}, im{};
  friend Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator+(Complex a, double b) { return {a.re + b, a.im}; }
  friend Complex operator-(Complex a, double b) { return {a.re - b, a.im}; }
  friend Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
  friend Complex operator*(double a, Complex b) { return {a * b.re, a * b.im}; }
  friend Complex operator/(Complex a, Complex b) {
    const Real d = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
  }
  [[nodiscard]] Real norm() const { return re * re + im * im; }
  [[nodiscard]] Complex<double> orbit(std::size_t i) const { return {lane(re, i), lane(im, i)}; }
};

constexpr double kBailout = 4, kMagnetBailout = 10000, kMagnetGoal = 1 / 10000.0;  ///< of squared distances

template <class Real>
Complex<Real> power(Complex<Real> z, int exponent) {
  Complex<Real> result = z;
  for (int i = 1; i < exponent; ++i) result = result * z;
  return result;
}

/// One step from z, and whether the orbit has then escaped.
template <class Real>
struct PowerStep {
  Complex<Real> c;
  int exponent;
  [[nodiscard]] Complex<Real> next(Complex<Real> z) const { return power(z, exponent) + c; }
  [[nodiscard]] static auto has_ended(Complex<Real> z) { return z.norm() > kBailout; }
};

/// z ↦ ((z² + c − 1) / (2z + c − 2))²; orbits end at infinity or at 1.
template <class Real>
struct Magnet1Step {
  Complex<Real> c;
  [[nodiscard]] Complex<Real> next(Complex<Real> z) const {
    const Complex<Real> quotient = (z * z + c - 1.0) / (z + z + c - 2.0);
    return quotient * quotient;
  }
  [[nodiscard]] static auto has_ended(Complex<Real> z) {
    return either(z.norm() > kMagnetBailout, (z - 1.0).norm() < kMagnetGoal);
  }
};

/// z ↦ ((z³ + 3(c − 1)z + (c − 1)(c − 2)) / (3z² + 3(c − 2)z + (c − 1)(c − 2) + 1))².
template <class Real>
struct Magnet2Step {
  Complex<Real> c1, c2, c12;  ///< c − 1, c − 2, and their product
  explicit Magnet2Step(Complex<Real> c) : c1(c - 1.0), c2(c - 2.0), c12(c1 * c2) {}
  [[nodiscard]] Complex<Real> next(Complex<Real> z) const {
    const Complex<Real> quotient = (z * z * z + 3.0 * c1 * z + c12) / (3.0 * z * z + 3.0 * c2 * z + c12 + 1.0);
    return quotient * quotient;
  }
  [[nodiscard]] static auto has_ended(Complex<Real> z) { return Magnet1Step<Real>::has_ended(z); }
};

/// The value of a point outside the set, whose orbit ended at z after `iterations` steps.
double exterior(const Fractal& o, double iterations, Complex<double> z) {
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

double interior(const Fractal& o, Complex<double> z, double least_norm) {
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

/// Turns of an orbit's loop that are counted together. They take at most a few microseconds, as other steps do
/// (base/stop_flag.h).
constexpr double kTurnsCounted = 256;

template <class Real, class Step>
void follow_orbits(const Fractal& o, Complex<Real> z, Real least_norm, const Step& step, StepCounter& steps,
                   double* values) {
  bool is_open[kOrbits<Real>];
  std::size_t open = std::size(is_open);
  std::fill_n(is_open, open, true);
  for (double i = 0; i < o.iterations;) {
    const double end = std::min(i + kTurnsCounted, o.iterations);
    for (; i < end; ++i) {
      z = step.next(z);
      const Real norm = z.norm();
      least_norm = norm < least_norm ? norm : least_norm;
      const auto has_ended = step.has_ended(z);
      for (std::size_t k = 0; k < std::size(is_open); ++k) {
        const bool ends = is_open[k] && lane(has_ended, k);
        if (!ends) continue;
        values[k] = exterior(o, i, z.orbit(k));
        is_open[k] = false;
        if (--open == 0) return;
      }
    }
    if (steps.take(static_cast<std::uint64_t>(kTurnsCounted) * open)) continue;
    std::fill_n(values, std::size(is_open), 0.0);
    return;
  }
  for (std::size_t k = 0; k < std::size(is_open); ++k) {
    if (is_open[k]) values[k] = interior(o, z.orbit(k), lane(least_norm, k));
  }
}

/// The values at as many points as Real has numbers.
template <class Real>
void fractals_at(const Fractal& o, const Complex<Real>& point, StepCounter& steps, double* values) {
  const Real zero{};
  const Complex<Real> c = o.is_julia ? Complex<Real>{zero + o.real, zero + o.imaginary} : point;
  if (o.magnet == 0) return follow_orbits(o, point, point.norm(), PowerStep<Real>{c, o.exponent}, steps, values);
  // The start of a magnet's Mandelbrot set is 0 and does not count as near to it.
  const Complex<Real> start = o.is_julia ? point : Complex<Real>{};
  const Real least_norm = o.is_julia ? point.norm() : zero + kMagnetBailout;
  if (o.magnet == 1) return follow_orbits(o, start, least_norm, Magnet1Step<Real>{c}, steps, values);
  follow_orbits(o, start, least_norm, Magnet2Step<Real>(c), steps, values);
}

double fractal_at(const PatternPoint& at) noexcept {
  double value = 0;
  fractals_at(at.operands<Fractal>(), Complex<double>{at.point.x, at.point.y}, at.environment.steps(), &value);
  return value;
}

void fractal_near(const PatternPoint& at, std::span<const Vec3> points, std::span<double> values) noexcept {
  const Fractal& o = at.operands<Fractal>();
  StepCounter& steps = at.environment.steps();
  std::size_t i = 0;
  for (; i + 1 < points.size(); i += 2) {
    const Vec3 &a = points[i], &b = points[i + 1];
    fractals_at(o, Complex<Pair>{Pair{a.x, b.x}, Pair{a.y, b.y}}, steps, &values[i]);
  }
  for (; i < points.size(); ++i) fractals_at(o, Complex<double>{points[i].x, points[i].y}, steps, &values[i]);
}

// ---- Operands -------------------------------------------------------------------------------------------------------

/// `mandel N`, `julia <re, im>, N`, `magnet T mandel N`, `magnet T julia <re, im>, N`.
void read_fractal(scene::OperandReader& reader, Fractal& fractal, std::string_view word) noexcept {
  if (word == "magnet") {
    fractal.magnet = reader.whole_in("the type of a `magnet`", 1, 2);
    fractal.is_julia = reader.accept_word("julia");
    if (!fractal.is_julia && !reader.accept_word("mandel"))
      reader.expected("`mandel` or `julia` after the type of a `magnet`");
  } else {
    fractal.is_julia = word == "julia";
  }
  if (fractal.is_julia) {
    const Vec3 c = reader.vector("a complex number as a vector");
    fractal.real = c.x;
    fractal.imaginary = c.y;
    reader.accept_comma();
  }
  constexpr double kMaxIterations = 4294967295.0;  // of POV-Ray's 32 bits
  const double iterations = std::floor(reader.number("the number of iterations"));
  fractal.iterations = iterations >= 0 ? std::min(iterations, kMaxIterations) : 0;
  if (fractal.iterations != iterations)
    reader.warn(fmt::format("the number of iterations must be at least 0, found {:g}", iterations));
}

/// POV-Ray warns of an exponent that it does not support, and takes 2.
void read_exponent(scene::OperandReader& reader, Fractal& fractal) noexcept {
  const double exponent = reader.number("`exponent`");
  if (fractal.magnet != 0) return reader.fail("`exponent` is not allowed with `magnet`");
  const bool is_known = exponent >= 2 && exponent < 34;
  if (!is_known) reader.warn(fmt::format("`exponent` must be from 2 to 33, found {:g}; 2 is used", exponent));
  fractal.exponent = is_known ? static_cast<int>(exponent) : 2;
}

void read_exterior(scene::OperandReader& reader, Fractal& fractal) noexcept {
  fractal.exterior_type = reader.whole_in("the type of the `exterior`", 0, 6);
  reader.accept_comma();
  fractal.exterior_factor = reader.number("a factor");
}

void read_interior(scene::OperandReader& reader, Fractal& fractal) noexcept {
  fractal.interior_type = reader.whole_in("the type of the `interior`", 0, 6);
  reader.accept_comma();
  fractal.interior_factor = reader.number("a factor");
}

using Numbers = std::vector<std::variant<double, int>>;
std::string form_of(const Fractal& fractal) { return fractal.is_julia ? "julia" : "mandel"; }
Numbers c_of(const Fractal& fractal) { return {fractal.real, fractal.imaginary}; }
Numbers exterior_of(const Fractal& fractal) { return {fractal.exterior_type, fractal.exterior_factor}; }
Numbers interior_of(const Fractal& fractal) { return {fractal.interior_type, fractal.interior_factor}; }

constexpr scene::OperandField kFractal[] = {
    scene::dumped<Fractal, form_of>("type"),
    scene::operand<&Fractal::magnet>("magnet").dumped_with<&Fractal::magnet>(),
    scene::dumped<Fractal, c_of>("c").dumped_with<&Fractal::is_julia>(),
    scene::operand<&Fractal::iterations>("iterations"),
    scene::modifier<&Fractal::exponent>("exponent").read_by<read_exponent>(),
    scene::dumped<Fractal, exterior_of>("exterior").with_word("exterior").read_by<read_exterior>(),
    scene::dumped<Fractal, interior_of>("interior").with_word("interior").read_by<read_interior>(),
};

constexpr std::string_view kWords[] = {"mandel", "julia", "magnet"};

constexpr PatternColour kMandelColours[] = {{0, 0, 0, 0},     {0.001, 0, 0, 0}, {0.001, 0, 1, 1},
                                            {0.012, 1, 1, 0}, {0.015, 1, 0, 1}, {0.1, 0, 1, 1}};
bool is_mandel(const std::any& record) {
  const auto& fractal = *std::any_cast<Fractal>(&record);
  return !fractal.is_julia && fractal.magnet == 0;
}

}  // namespace

constinit const PatternInfo pattern_kinds::fractal{.words = kWords,
                                                   .colours = kMandelColours,
                                                   .has_colours = is_mandel,
                                                   .operands = operands_of<Fractal, kFractal>,
                                                   .read = read_operands<Fractal, read_fractal>,
                                                   .value = fractal_at,
                                                   .values_near = fractal_near};

}  // namespace isl::render
