// The type of the reference's numbers. Its sources are compiled twice: in namespace isl::reference with long double
// and, where the compiler has it, in isl::wide_reference with a binary type of 113 bits. The second is what a target
// gets that links isl::wide_reference, which defines ISL_WIDE_REFERENCE. A file that serves both writes `Real`,
// `namespace isl::ISL_REFERENCE`, and the functions below without `std::`; no file can include both.
//
// The type of 113 bits is computed in software, some fifteen times as slowly.
#pragma once

#include <cmath>
#include <limits>

#ifdef ISL_WIDE_REFERENCE
#define ISL_REFERENCE wide_reference
#else
#define ISL_REFERENCE reference
#endif

namespace isl::ISL_REFERENCE {

#ifdef ISL_WIDE_REFERENCE

__extension__ typedef __float128 Real;  // NOLINT: only a typedef can be marked as an extension

inline constexpr int kDigits = 113;

// The standard library's functions would convert to a shorter type.
[[nodiscard]] inline Real abs(Real x) { return fabsf128(x); }
[[nodiscard]] inline Real sqrt(Real x) { return sqrtf128(x); }
[[nodiscard]] inline Real hypot(Real x, Real y) { return hypotf128(x, y); }
[[nodiscard]] inline Real exp(Real x) { return expf128(x); }
[[nodiscard]] inline Real expm1(Real x) { return expm1f128(x); }
[[nodiscard]] inline Real log(Real x) { return logf128(x); }
[[nodiscard]] inline Real log1p(Real x) { return log1pf128(x); }
[[nodiscard]] inline Real sin(Real x) { return sinf128(x); }
[[nodiscard]] inline Real cos(Real x) { return cosf128(x); }
[[nodiscard]] inline Real asin(Real x) { return asinf128(x); }
[[nodiscard]] inline Real asinh(Real x) { return asinhf128(x); }

#else

using Real = long double;

inline constexpr int kDigits = std::numeric_limits<Real>::digits;
static_assert(kDigits >= 64, "the reference needs an 80-bit long double");

using std::abs;
using std::asin;
using std::asinh;
using std::cos;
using std::exp;
using std::expm1;
using std::hypot;
using std::log;
using std::log1p;
using std::sin;
using std::sqrt;

#endif

/// The relative error of one operation is at most this: 2⁻⁶⁴, or 2⁻¹¹³.
inline constexpr Real kRoundoff = kDigits == 113 ? 0x1p-113L : 0x1p-64L;
/// Covers that of one operation and of the arithmetic that widens its result by this.
inline constexpr Real kRounding = 4 * kRoundoff;

/// From double, because the standard library does not describe the wide type.
inline constexpr Real kInfiniteReal = std::numeric_limits<double>::infinity();
/// Two terms, because a literal has the digits of a long double at most.
inline constexpr Real kPi = 0x3.243f6a8885a308dp0L + Real(0x3.13198a2e0370734p-64L);

}  // namespace isl::ISL_REFERENCE
