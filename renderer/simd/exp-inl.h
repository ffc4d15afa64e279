// e^y for y ≤ 709, the same in every lane. This is our own function, because libm's last bits differ between machines
// and pictures must not.
//
// y = n ln 2 + r with |r| ≤ ln 2 / 2; e^r by its Taylor polynomial of degree 13 (remainder r¹⁴/14! < 4.2e-18 relative),
// n by adding to the exponent's bits. ln 2 is split in two (Cody and Waite), the upper part with 21 zero bits at its
// end so that n·kLn2High is exact for |n| < 2²¹. The relative error stays below 2 units in the last place
// (tests/renderer/simd measures it against MPFR). Below −708 the result is 0: it would be denormal.
#if defined(ISL_RENDERER_SIMD_EXP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SIMD_EXP_INL_H_
#undef ISL_RENDERER_SIMD_EXP_INL_H_
#else
#define ISL_RENDERER_SIMD_EXP_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

HWY_INLINE double exp(double y) { return std::exp(y); }

/// n and r of y = n ln 2 + r.
struct ReducedExponent {
  OctetMask in_range;  ///< the lanes where 2ⁿ is no denormal number; in others y is taken for 0
  Octet shifted;       ///< n in the low bits
  Octet r;

  HWY_INLINE explicit ReducedExponent(const Octet& y) {
    constexpr double kLog2E = 0x1.71547652b82fep+0;
    constexpr double kLn2High = 0x1.62e42feep-1;       // the upper 32 bits of ln 2
    constexpr double kLn2Low = 0x1.a39ef35793c76p-33;  // the rest of ln 2
    // Adding 1.5·2⁵² leaves the nearest integer in the low bits of the sum.
    constexpr double kShift = 0x1.8p52;
    constexpr double kLeast = -708;
    in_range = y >= Octet(kLeast);
    const Octet x = keep(in_range, y);
    shifted = x * Octet(kLog2E) + Octet(kShift);
    const Octet n = shifted - Octet(kShift);
    r = (x - n * Octet(kLn2High)) - n * Octet(kLn2Low);
  }

  /// 2ⁿ p, or 0 where y is out of range.
  [[nodiscard]] HWY_INLINE Octet scaled(const Octet& p) const {
    const hn::Rebind<std::int64_t, Lanes> integers;
    Octet result;
    for (std::size_t i = 0; i < kRegisters; ++i) {
      const auto exponent = hn::ShiftLeft<52>(hn::BitCast(integers, shifted.v[i]));
      result.v[i] = hn::BitCast(Lanes(), hn::Add(hn::BitCast(integers, p.v[i]), exponent));
    }
    return keep(in_range, result);
  }
};

HWY_INLINE Octet exp(const Octet& y) {
  const ReducedExponent x(y);
  // e^r = 1 + r + r² q(r). The terms of q are summed in pairs, pairs of pairs and so on (Estrin's scheme), because a
  // field waits for its exponential, and Horner's rule would be one chain of 26 operations.
  const Octet &r = x.r, r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  const auto four = [&](double c0, double c1, double c2, double c3) HWY_ATTR {
    return (Octet(1 / c0) + Octet(1 / c1) * r) + (Octet(1 / c2) + Octet(1 / c3) * r) * r2;
  };
  const Octet q =
      (four(2, 6, 24, 120) + four(720, 5040, 40320, 362880) * r4) + four(3628800, 39916800, 479001600, 6227020800) * r8;
  return x.scaled((q * r2 + r) + Octet(1.0));
}

/// exp_above() exceeds the exponential by at most this share of it.
inline constexpr double kExpAbove = 0.001;

/// An upper bound of e^y for y ≤ 709, in less than half the time of exp(). The Taylor polynomial of degree 3 is too
/// small by at most r⁴/24 · max(1, e^r), which is 0.00086 of e^r.
HWY_INLINE Octet exp_above(const Octet& y) {
  const ReducedExponent x(y);
  constexpr double kAbove = 1 + kExpAbove;
  const Octet &r = x.r, r2 = r * r;
  return x.scaled((Octet(kAbove) + Octet(kAbove) * r) + (Octet(kAbove / 2) + Octet(kAbove / 6) * r) * r2);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
