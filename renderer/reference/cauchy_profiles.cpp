// Cauchy's kernel 1/(ε + q)² less its tangent at the border Q, and what becomes of it when it is convolved with a
// plane:
//   point  φ = d²·(B + 2Y)/(B + 2Y₁)·(Y₁/Y)²,  Q − 1 = 2(1 + ε)t/(√(9 + 4t) + 3),  t = 6/(h(1 + ε) − 2)
//   plane  φ = d³·Y₁/Y,                        Q − 1 = 3(1 + ε)/(h(1 + ε) − 1)
// with Y = ε + q, Y₁ = ε + 1, B = ε + Q and d = (Q − q)/(Q − 1). The borders follow from φ′(1) = −h; they are real for
// h(1 + ε) above 2 or 1. Then ln φ(0) falls as ε grows, and is h at the ε that is meant.
#include "renderer/reference/kernel_profiles.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

Interval log_of(const Interval& x) {
  return rising([](Real at) { return log(at); }, x, kLibrary);
}
Interval log_of_one_plus(const Interval& x) {
  return rising([](Real at) { return log1p(at); }, x, kLibrary);
}

/// ε and Q − 1. With e = h(1 + ε) − least, least being 2 or 1, ε = (e + least)/h − 1; it is searched for by the
/// logarithm of ε itself or, if ε must exceed least/h − 1 > 0, of e.
struct CauchyConstants {
  CauchyConstants(Real hardness, Real least_product, const Interval& log_unknown) : h(hardness) {
    const Interval unknown = rising([](Real at) { return exp(at); }, log_unknown, kLibrary);
    const Interval least = Interval(least_product);
    if (hardness < least_product) {
      excess = unknown;
      epsilon = (excess + (least - h)) / h;
    } else {
      epsilon = unknown;
      excess = h * epsilon + (h - least);
    }
  }

  Interval h, epsilon, excess;  ///< excess: h(1 + ε) − least
};

struct CauchyPoint : CauchyConstants {
  CauchyPoint(Real hardness, const Interval& log_unknown) : CauchyConstants(hardness, 2, log_unknown) {
    const Interval t = Interval(6) / excess;
    beyond = Interval(2) * (Interval(1) + epsilon) * t / (square_root(Interval(9) + Interval(4) * t) + Interval(3));
  }
  /// ln φ(0) − h. (B + 2ε)/(B + 2Y₁) = 1 − 2/(B + 2Y₁).
  [[nodiscard]] Interval excess_in_the_middle() const {
    return Interval(2) * (log_of_one_plus(Interval(1) / beyond) + log_of_one_plus(epsilon) - log_of(epsilon)) +
           log_of_one_plus(Interval(-2) / slant_at_one()) - h;
  }
  /// B + 2Y₁
  [[nodiscard]] Interval slant_at_one() const { return Interval(3) * (Interval(1) + epsilon) + beyond; }

  Interval beyond;
};

struct CauchyPlane : CauchyConstants {
  CauchyPlane(Real hardness, const Interval& log_unknown) : CauchyConstants(hardness, 1, log_unknown) {
    beyond = Interval(3) * (Interval(1) + epsilon) / excess;
  }
  [[nodiscard]] Interval excess_in_the_middle() const {
    return Interval(3) * log_of_one_plus(Interval(1) / beyond) + log_of_one_plus(epsilon) - log_of(epsilon) - h;
  }

  Interval beyond;
};

/// The greatest is beyond any hardness that a database has.
constexpr Real kLeastLog = -600, kMostLog = 2000;

template <class Kind>
Kind solved(Real hardness, Real least_log) {
  const auto excess = [&](Real at) { return Kind(hardness, at).excess_in_the_middle(); };
  return Kind(hardness, zero_of_falling(excess, least_log, kMostLog));
}

}  // namespace

ProfileInUse cauchy_profile(const scene::Kernel& kernel) {
  const auto k = solved<CauchyPoint>(kernel.hardness, kLeastLog);
  const Interval at_one = Interval(1) + k.epsilon, slant = k.slant_at_one(), factor = square(at_one) / slant;
  const Interval border = at_one + k.beyond, fall = Interval(1) / k.beyond;
  const auto profile = [=](const Jet& q) {
    const Jet y = q + k.epsilon;
    return positive_square(depth_at(q, fall)) * ((y + y + border) * square(inverse(y)) * factor);
  };
  return {profile, Interval(1) + k.beyond};
}

/// ε is at least 10⁻⁴⁰.
ProfileInUse cauchy_sheet_profile(const scene::Kernel& kernel) {
  const auto k = solved<CauchyPlane>(kernel.hardness, -40 * log(Real(10)));
  const Interval at_one = Interval(1) + k.epsilon, fall = Interval(1) / k.beyond;
  const auto profile = [=](const Jet& q) {
    const Jet depth = depth_at(q, fall);
    return positive_square(depth) * depth * (inverse(q + k.epsilon) * at_one);
  };
  return {profile, Interval(1) + k.beyond};
}

}  // namespace isl::ISL_REFERENCE
