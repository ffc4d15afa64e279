// Integrals of the Cauchy window over a part of a curve that is nowhere deeper in the support than a small share of B.
// With the depth d = 1 − y and Y = B − d the window is d²(B + 2Y)/(Y²B³), and all of it is positive. The closed forms
// of segment_cauchy-inl.h and ring_cauchy-inl.h are differences there, which lose digits in proportion to (B/d)²; the
// surfaces of hard kernels are as close to the border as d/B = 2.5/h. Gauss's rule sums what nothing is lost from.
// Kernels whose surface is deeper than B/8 do without the sum: the error of the closed forms is the same at all depths,
// and what it moves the surface by is decided where the surface lies.
//
// At most 1/32 of B deep, (B + 2Y)/Y² = Σ(k + 3)dᵏ/B^{k+1}. Along a segment d is a quadratic, so the rule of 8 points
// is right up to the term k = 5, and the next ones are below 10⁻¹³ of the integral. Along a ring d = S − 2a sin²(φ/2);
// of a whole one, where cos φ turns through all its values, the rule of 16 points sums cos 2φ to 10⁻¹⁸, cos 3φ to 10⁻¹³
// and cos 4φ to 10⁻⁹, which have shares of at most 4·10⁻³ and 4·10⁻⁵ in the terms of k = 1 and 2: below 10⁻¹³ too.
// Rounding of y at such a depth moves the field by some 5 B/d ≥ 160 units in the last place, which is as much.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_BORDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_BORDER_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_BORDER_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_BORDER_INL_H_
#endif

#include "renderer/fields/convolutions/arc_math-inl.h"
#include "renderer/fields/convolutions/cauchy_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The greatest depth over B for which these integrals hold.
inline constexpr double kShallow = 1.0 / 32;

struct GaussPoint {
  double place, weight;  ///< of the points ±place in [−1, 1]
};
inline constexpr GaussPoint kGauss8[] = {{0.183434642495649805, 0.362683783378361983},
                                         {0.525532409916328986, 0.313706645877887287},
                                         {0.79666647741362674, 0.222381034453374471},
                                         {0.960289856497536232, 0.101228536290376259}};
inline constexpr GaussPoint kGauss16[] = {
    {0.0950125098376374402, 0.189450610455068496}, {0.281603550779258913, 0.182603415044923589},
    {0.458016777657227386, 0.169156519395002538},  {0.617876244402643748, 0.149595988816576732},
    {0.755404408355003034, 0.124628971255533872},  {0.865631202387831744, 0.0951585116824927848},
    {0.944575023073232576, 0.0622535239386478929}, {0.989400934991649933, 0.0271524594117540949}};

/// The window at a depth, times B³.
template <class N>
[[nodiscard]] HWY_INLINE N at_depth(const CauchyWindow& window, const N& depth) {
  const N d = max(depth, N(0.0)), b(window.border), y = b - d, share = d / y;
  return share * share * (b + N(2.0) * y);
}

/// sin x for 0 ≤ x ≤ π/2. The series up to x²¹ leaves less than 10⁻¹⁷.
template <class N>
[[nodiscard]] HWY_INLINE N sine_of(const N& x) {
  constexpr auto kSeries = [] {
    std::array<double, 11> c{};
    double term = 1;
    for (std::size_t k = 0; k < c.size(); ++k) {
      c[k] = term;
      const auto n = static_cast<double>(2 * k + 2);
      term /= -n * (n + 1);
    }
    return c;
  }();
  return x * power_series(kSeries, x * x);
}

/// The integral along a line, v from middle − half to middle + half, where y = ρ² + v².
template <class N>
[[nodiscard]] HWY_INLINE N integral_at_border(const CauchyWindow& window, const N& rho2, const N& middle,
                                              const N& half) {
  const N deepest = N(1.0) - rho2;
  N sum(0.0);
  for (const GaussPoint& point : kGauss8) {
    const N step = half * N(point.place), before = middle - step, behind = middle + step;
    sum = sum +
          N(point.weight) * (at_depth(window, deepest - before * before) + at_depth(window, deepest - behind * behind));
  }
  return sum * half * N(1 / (window.border * window.border * window.border));
}

/// The integral over the angle, φ from −μ to μ, of a ring: y = 1 − S + 2a sin²(φ/2).
template <class N>
[[nodiscard]] HWY_INLINE N ring_at_border(const CauchyWindow& window, const N& s, const N& a, const N& angle) {
  const N half = N(0.5) * angle, two_a = N(2.0) * a;
  N sum(0.0);
  for (const GaussPoint& point : kGauss16) {
    const N sine = sine_of(half * N(point.place));
    sum = sum + N(point.weight) * at_depth(window, s - two_a * (sine * sine));
  }
  return N(2.0) * sum * angle * N(1 / (window.border * window.border * window.border));
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
