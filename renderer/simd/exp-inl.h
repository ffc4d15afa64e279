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

/// Adding this leaves the nearest integer in the low bits of the sum.
inline constexpr double kShift = 0x1.8p52;
inline constexpr double kLog2E = 0x1.71547652b82fep+0;
/// Above this e^y is a normal number.
inline constexpr double kLeastExponent = -708;

/// 2ⁿ p, where the low bits of `shifted` are n.
HWY_INLINE Octet times_power(const Octet& shifted, const Octet& p) {
  const hn::Rebind<std::int64_t, Lanes> integers;
  Octet result;
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const auto exponent = hn::ShiftLeft<52>(hn::BitCast(integers, shifted.v[i]));
    result.v[i] = hn::BitCast(Lanes(), hn::Add(hn::BitCast(integers, p.v[i]), exponent));
  }
  return result;
}

/// 2^{j/8}.
alignas(64) inline constexpr double kPowersOfTwo[8] = {0x1p+0,
                                                       0x1.172b83c7d517bp+0,
                                                       0x1.306fe0a31b715p+0,
                                                       0x1.4bfdad5362a27p+0,
                                                       0x1.6a09e667f3bcdp+0,
                                                       0x1.8ace5422aa0dbp+0,
                                                       0x1.ae89f995ad3adp+0,
                                                       0x1.d5818dcfba487p+0};

/// e^y, off by at most two units in the last place; 0 where that is no normal number. y ≤ 709.
HWY_INLINE Octet exp(const Octet& y) {
  constexpr double kLn2High = 0x1.62e42feep-4;       // the upper 32 bits of ln 2 / 8
  constexpr double kLn2Low = 0x1.a39ef35793c76p-36;  // the rest of it
  const OctetMask in_range = y >= Octet(kLeastExponent);
  const Octet x = keep(in_range, y);
  const Octet shifted = x * Octet(8 * kLog2E) + Octet(kShift), k = shifted - Octet(kShift);
  const Octet r = (x - k * Octet(kLn2High)) - k * Octet(kLn2Low);
  // y = k/8 ln 2 + r, |r| ≤ ln 2 / 16. e^r = 1 + r + r² q(r), q by its values at six Chebyshev nodes: 1e-17 off.
  const Octet r2 = r * r, r4 = r2 * r2;
  const auto two = [&](double c0, double c1) HWY_ATTR { return Octet(c0) + Octet(c1) * r; };
  const Octet q =
      (two(0x1.000000000002ep-1, 0x1.555555555556ap-3) + two(0x1.5555554e93acap-5, 0x1.1111110e10556p-7) * r2) +
      two(0x1.6c1b7131a0993p-10, 0x1.a01e2c15a33f3p-13) * r4;
  const Octet p = q * r2 + r;
  const hn::Rebind<std::int64_t, Lanes> integers;
  Octet result;
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const auto bits = hn::BitCast(integers, shifted.v[i]);
    const auto eighth = hn::And(bits, hn::Set(integers, 7));
    Register power;
    if constexpr (kRegisters == 1) {
      power = hn::TableLookupLanes(hn::Load(Lanes(), kPowersOfTwo), hn::IndicesFromVec(Lanes(), eighth));
    } else {
      power = hn::GatherIndex(Lanes(), kPowersOfTwo, eighth);
    }
    const auto whole = hn::ShiftLeft<49>(hn::AndNot(hn::Set(integers, 7), bits));
    result.v[i] = hn::BitCast(Lanes(), hn::Add(hn::BitCast(integers, hn::Add(power, hn::Mul(power, p.v[i]))), whole));
  }
  return keep(in_range, result);
}

/// exp_above() exceeds the exponential by at most this share of it, where that is a normal number.
inline constexpr double kExpAbove = 0.0038;

/// An upper bound of e^y for y ≤ 709, in a third of the operations of exp(). With y log₂e = n + f, |f| ≤ ½, the
/// quadratic is at least 2^f and at most kExpAbove above it.
HWY_INLINE Octet exp_above(const Octet& y) {
  const Octet x = max(y, Octet(kLeastExponent)) * Octet(kLog2E), shifted = x + Octet(kShift);
  const Octet f = x - (shifted - Octet(kShift));
  return times_power(shifted, Octet(1.0024) + (Octet(0.704663) + Octet(0.238841) * f) * f);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
