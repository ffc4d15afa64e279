// The numbers of the reference. Its sources are compiled twice: in namespace isl::reference with long double and, where
// the compiler has it, in isl::wide_reference with a binary type of 113 bits. The second is what a target gets that
// links isl::wide_reference, which defines ISL_WIDE_REFERENCE. A file that serves both writes `Real`,
// `namespace isl::ISL_REFERENCE`, and the functions below without `std::`; no file can include both.
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

/// Computed in software, some thirty times as slowly.
__extension__ typedef __float128 Real;  // NOLINT: only a typedef can be marked as an extension

inline constexpr int kDigits = 113;

// The standard library's functions would convert to a shorter type.
[[nodiscard]] inline Real abs(Real x) { return x < 0 ? -x : x; }
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

/// Errors and radii need few digits, but as many exponents.
using Size = long double;

/// The relative error of one operation is at most this: 2⁻⁶⁴, or 2⁻¹¹³.
inline constexpr Size kRoundoff = kDigits == 113 ? 0x1p-113L : 0x1p-64L;

/// From double, because the standard library does not describe the wide type.
inline constexpr Real kInfiniteReal = std::numeric_limits<double>::infinity();

}  // namespace isl::ISL_REFERENCE
