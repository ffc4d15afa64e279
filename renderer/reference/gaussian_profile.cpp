// Blinn's exponential less its tangent at the place where it has fallen to δ = 1/1000 of its value at q = 1:
//   φ = (exp(g(1 − q)) − δ(1 + g(Q − q)))/(1 − δ(1 + ln 1/δ)) = δ(eˣ − 1 − x)/(1 − δ(1 + ln 1/δ)),
// with x = g(Q − q) = ln 1/δ + g(1 − q), whose values at the surface and at the border are ln 1/δ and 0.
#include "renderer/reference/kernel_profiles.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

/// Later terms add nothing to the series of eˣ for x ≤ 1: 1/29! is 2⁻¹⁰², and 1/39! is 2⁻¹⁵³.
constexpr int kTerms = kDigits > 64 ? 40 : 30;

/// eˣ − 1 − x for x ≥ 0, given eˣ − 1. Below 1 the difference would cancel; there it is x²/2 (1 + x/3 (1 + x/4 (1 +
/// …))).
Real exponential_remainder(Real x, Real once) {
  if (x > 1) return once - x;
  Real sum = 1;
  for (int k = kTerms; k > 2; --k) sum = 1 + sum * x / k;
  return x * x / 2 * sum;
}

}  // namespace

ProfileInUse gaussian_profile(const scene::Kernel& kernel) {
  const Interval delta = Interval(1) / Interval(1000),
                 log_delta = rising([](Real x) { return log(x); }, 1000, kLibrary);
  const Interval rest = Interval(1) - delta * (Interval(1) + log_delta), amplitude = delta / rest;
  const Interval g = Interval(kernel.hardness) * rest / (Interval(1) - delta);
  const auto profile = [=](const Jet& q) {
    const Jet x = (Interval(1) - q) * g + log_delta;
    if (x.value.hi() <= 0) return Jet();
    // Let r be the error of x. It moves eˣ − 1 − x by at most (eˣ − 1) r at the greatest x, and eˣ − 1 by at most eˣ r.
    // For r ≤ 1, eʳ is at most 1 + 2r.
    const Interval p = positive_part(x.value);
    const Real at = std::max(p.middle(), Real(0)), e = expm1(at);
    const Interval least = Interval::rounded(e, 0, kLibrary);
    const Interval growth = p.radius() < 1 ? Interval(1 + 2 * p.radius()) : Interval(kUnbounded);
    const Interval steepest = (least + Interval(1)) * growth;
    const Interval off = Interval::around(0, p.radius());
    const Interval once = least + steepest * off;
    const Interval twice =
        Interval::rounded(exponential_remainder(at, e), 0, kLibrary) + (steepest - Interval(1)) * off;
    return chain(twice, once, (once + Interval(1)) * step(x.value), x) * amplitude;
  };
  return {profile, Interval(1) + log_delta / g};
}

}  // namespace isl::ISL_REFERENCE
