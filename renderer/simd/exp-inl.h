// e^y for y ≤ 709, the same in every lane. This is our own function, because libm's last bits differ between machines
// and pictures must not.
//
// y = n ln 2 + r with |r| ≤ ln 2 / 2; e^r by its Taylor polynomial of degree 13 (remainder r¹⁴/14! < 4.2e-18 relative),
// n by adding to the exponent's bits. ln 2 is split in two (Cody and Waite), the upper part with 21 zero bits at its
// end so that n·kLn2High is exact for |n| < 2²¹. With the rounding of Horner's scheme the relative error stays below 2
// units in the last place (tests/renderer/fields measures it against MPFR). Below −708 the result is 0: it would be
// denormal.
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

HWY_INLINE Octet exp(const Octet& y) {
  constexpr double kLog2E = 0x1.71547652b82fep+0;
  constexpr double kLn2High = 0x1.62e42feep-1;       // the upper 32 bits of ln 2
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;  // the rest of ln 2
  // Adding 1.5·2⁵² leaves the nearest integer in the low bits of the sum.
  constexpr double kShift = 0x1.8p52;
  constexpr double kLeast = -708;

  const OctetMask in_range = y >= Octet(kLeast);
  const Octet shifted = keep(in_range, y) * Octet(kLog2E) + Octet(kShift);
  const Octet n = shifted - Octet(kShift);
  const Octet r = (keep(in_range, y) - n * Octet(kLn2High)) - n * Octet(kLn2Low);

  Octet p(1.0 / 6227020800.0);
  for (const double factorial :
       {479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0}) {
    p = p * r + Octet(1.0 / factorial);
  }
  p = (p * r + Octet(1.0)) * r + Octet(1.0);

  const hn::Rebind<std::int64_t, Lanes> integers;
  Octet result;
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const auto exponent = hn::ShiftLeft<52>(hn::BitCast(integers, shifted.v[i]));
    result.v[i] = hn::BitCast(Lanes(), hn::Add(hn::BitCast(integers, p.v[i]), exponent));
  }
  return keep(in_range, result);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
