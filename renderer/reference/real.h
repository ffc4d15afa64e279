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

/// The library's functions that the reference calls.
#define ISL_REFERENCE_FUNCTIONS(function)                                                                \
  function(sqrt) function(exp) function(expm1) function(log) function(log1p) function(sin) function(cos) \
      function(asin) function(asinh)

namespace isl::ISL_REFERENCE {

#ifdef ISL_WIDE_REFERENCE
/// Computed in software, some thirty times as slowly.
__extension__ typedef __float128 Real;  // NOLINT: only a typedef can be marked as an extension
inline constexpr int kDigits = 113;

// Those of the standard library would convert to a shorter type.
#define ISL_WIDE(name) \
  [[nodiscard]] inline Real name(Real x) { return name##f128(x); }
ISL_REFERENCE_FUNCTIONS(ISL_WIDE)
#undef ISL_WIDE
[[nodiscard]] inline Real hypot(Real x, Real y) { return hypotf128(x, y); }
[[nodiscard]] inline Real abs(Real x) { return x < 0 ? -x : x; }
#else
using Real = long double;
inline constexpr int kDigits = std::numeric_limits<Real>::digits;
static_assert(kDigits >= 64, "a long double of 80 bits is expected");

#define ISL_LONG(name) using std::name;
ISL_REFERENCE_FUNCTIONS(ISL_LONG)
#undef ISL_LONG
using std::abs;
using std::hypot;
#endif

/// Errors and radii need few digits, but as many exponents.
using Size = long double;

/// The relative error of one operation is at most this: 2⁻⁶⁴, or 2⁻¹¹³.
inline constexpr Size kRoundoff = kDigits == 113 ? 0x1p-113L : 0x1p-64L;

/// From double, because the standard library does not describe the wide type.
inline constexpr Real kInfiniteReal = std::numeric_limits<double>::infinity();

}  // namespace isl::ISL_REFERENCE

#undef ISL_REFERENCE_FUNCTIONS
