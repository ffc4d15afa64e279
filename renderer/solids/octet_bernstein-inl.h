// Polynomials in Bernstein form along eight lines (numerics/bernstein.h), and the places where each changes its sign
// for certain (numerics/polynomial_roots.h). The formulas are those of these files, operation by operation.
#if defined(ISL_RENDERER_SOLIDS_OCTET_BERNSTEIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_BERNSTEIN_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_BERNSTEIN_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_BERNSTEIN_INL_H_
#endif

#include "renderer/numerics/bernstein_root.h"
#include "renderer/simd/octet-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <int n>
struct OctetBernstein {
  Octet b[n + 1];

  HWY_INLINE Octet& operator[](int i) { return b[i]; }
  HWY_INLINE const Octet& operator[](int i) const { return b[i]; }
};

template <int n>
[[nodiscard]] HWY_INLINE OctetBernstein<n> with_binomials(const OctetBernstein<n>& p) {
  OctetBernstein<n> weighted;
  for (int i = 0; i <= n; ++i) weighted[i] = Octet(binomial(n, i)) * p[i];
  return weighted;
}

template <int n>
[[nodiscard]] HWY_INLINE OctetBernstein<n - 1> over_u(const OctetBernstein<n>& p) {
  OctetBernstein<n - 1> quotient;
  for (int i = 0; i < n; ++i) quotient[i] = p[i + 1] * Octet(n) / Octet(i + 1);
  return quotient;
}

template <int n>
HWY_INLINE void halve(OctetBernstein<n>& p, OctetBernstein<n>& right) {
  right[n] = p[n];
  for (int level = 1; level <= n; ++level) {
    for (int i = n; i >= level; --i) p[i] = Octet(0.5) * (p[i - 1] + p[i]);
    right[n - level] = p[n];
  }
}

/// Horner's rule at u from the nearer end, as value_at() and newton_step() have it.
template <int n>
class OctetHorner {
 public:
  HWY_INLINE OctetHorner(const OctetBernstein<n>& weighted, const Octet& u)
      : weighted_(weighted),
        is_low_(u <= Octet(0.5)),
        end_(select(is_low_, Octet(1.0) - u, u)),
        ratio_(select(is_low_, u, Octet(1.0) - u) / end_) {}

  [[nodiscard]] HWY_INLINE Octet value() const {
    Octet sum = coefficient(0), scale = end_;
    for (int i = 1; i < n; ++i) {
      sum = sum * ratio_ + coefficient(i);
      scale = scale * end_;
    }
    return (sum * ratio_ + coefficient(n)) * scale;
  }

  /// Newton's step to the root, and a number that has the sign of the value.
  HWY_INLINE void newton(Octet& sign_of_value, Octet& step) const {
    Octet q = coefficient(0), slope(0.0);
    for (int i = 1; i <= n; ++i) {
      slope = slope * ratio_ + q;
      q = q * ratio_ + coefficient(i);
    }
    const Octet drop = Octet(n) * end_ * q;
    sign_of_value = q;
    step = end_ * end_ * q / select(is_low_, slope - drop, drop - slope);
  }

 private:
  [[nodiscard]] HWY_INLINE Octet coefficient(int i) const { return select(is_low_, weighted_[n - i], weighted_[i]); }

  const OctetBernstein<n>& weighted_;
  OctetMask is_low_;
  Octet end_, ratio_;
};

/// As bernstein_root() of polynomials that fall from + to −, for some lanes.
template <int n>
[[nodiscard]] HWY_INLINE Octet bernstein_root(const OctetBernstein<n>& weighted, Octet low, Octet high, double enough,
                                              const OctetMask& lanes) {
  const Octet zero(0.0), half(0.5), infinity(std::numeric_limits<double>::infinity());
  const Octet f_low = OctetHorner<n>(weighted, low).value(), f_high = OctetHorner<n>(weighted, high).value();
  const OctetMask falls = f_high < zero;
  OctetMask open = lanes & (f_low > zero);
  Octet result = select(and_not(falls, open), high, low);
  open = open & falls;
  Octet last = infinity, u = low + (high - low) * (f_low / (f_low - f_high));
  const auto end = [&](const OctetMask& ended, const Octet& at) HWY_ATTR {
    result = select(ended, at, result);
    open = and_not(ended, open);
  };
  while (!none(open)) {
    u = select((u > low) & (u < high), u, low + half * (high - low));
    end(and_not((u > low) & (u < high), open), u);
    Octet value, step;
    OctetHorner<n>(weighted, u).newton(value, step);
    const OctetMask above = value > zero, below = value < zero;
    end(and_not(above | below, open), u);
    low = select(above, u, low);
    high = select(below, u, high);
    const Octet size = abs(step), next = u - step;
    const OctetMask is_inside = (next > low) & (next < high), shrinks = is_inside & (size <= half * last);
    end(open & is_inside & (size <= max(Octet(kLastDigits) * u, Octet(enough))), next);
    end(open & and_not(shrinks, last <= Octet(kFewDigits) * u), u);
    last = select(shrinks, size, infinity);
    u = select(shrinks, next, low + half * (high - low));
  }
  return result;
}

/// As SignFollower::root_between(), for polynomials that fall from + to − between low and high.
template <int n>
[[nodiscard]] HWY_INLINE Octet root_between(const OctetBernstein<n>& falling, const Octet& low, const Octet& high,
                                            double enough, const OctetMask& lanes) {
  return bernstein_root(with_binomials(falling), low, high, enough, lanes);
}
/// As quadratic_root_between(), whose roots do not depend on the polynomial's sign.
[[nodiscard]] HWY_INLINE Octet root_between(const OctetBernstein<2>& p, const Octet& low, const Octet& high,
                                            double enough, const OctetMask& lanes) {
  const Octet q = Octet(0.0) - (p[1] + copysign(sqrt(p[1] * p[1] - p[0] * p[2]), p[1]));
  const Octet first = q / (p[2] + q), second = p[0] / (q + p[0]);
  const Octet root = select((first >= low) & (first <= high), first, second);
  const OctetMask is_between = (root >= low) & (root <= high), others = and_not(is_between, lanes);
  if (none(others)) return root;
  return select(is_between, root, bernstein_root(with_binomials(p), low, high, enough, others));
}

/// Places where the signs of eight polynomials change for certain, in brackets, ascending.
struct OctetChanges {
  static constexpr std::size_t kMost = 4;
  OctetMask are_there[kMost];
  Octet low[kMost], high[kMost];
  OctetMask alone;  ///< lanes that need more than a few halvings
};

/// As SignFollower::bracket(), for some lanes. `sign` is the sign before 0, 1 or −1, and becomes that behind the last
/// change. Lanes end after `most` changes.
template <int n>
[[nodiscard]] HWY_INLINE OctetChanges changes_of(OctetBernstein<n> p, const Octet& band, const OctetMask& lanes,
                                                 std::size_t most, Octet& sign) {
  /// Lanes that need more are left alone: their line almost touches the surface.
  constexpr int kMostParts = 24;
  struct Part {
    OctetBernstein<n> p;
    Octet low, high;
    OctetMask is_waiting;  ///< lanes that have not looked at it
  };
  const Octet minus_band = Octet(0.0) - band;
  const auto is_some_below = [&](const OctetBernstein<n>& q) HWY_ATTR {
    OctetMask some = q[0] < minus_band;
    for (int i = 1; i <= n; ++i) some = some | (q[i] < minus_band);
    return some;
  };
  const auto signed_by = [&](OctetBernstein<n> q) HWY_ATTR {
    for (Octet& b : q.b) b = b * sign;
    return q;
  };
  OctetChanges result;
  for (OctetMask& there : result.are_there) there = no_lane();
  result.alone = no_lane();
  Part right[kMostParts];  // halves that wait for those on their left
  Octet low(0.0), high(1.0), certain(0.0);
  OctetMask open = lanes;
  for (int part = 0;; ++part) {
    const OctetBernstein<n> q = signed_by(p);
    const OctetMask may_cross = open & is_some_below(q);
    OctetMask has_changed = and_not(q[0] > band, all_lanes()), crosses = may_cross & (q[n] < minus_band);
    for (int i = 0; i < n; ++i) {
      crosses = and_not(has_changed & (q[i] > band), crosses);
      has_changed = has_changed | (q[i] < minus_band);
    }
    OctetMask is_done = and_not(and_not(crosses, may_cross), open);
    const OctetMask ends_certain = is_done & ((q[n] > band) | crosses);
    if (!none(crosses)) {
      OctetMask left = crosses;
      for (std::size_t k = 0; k < OctetChanges::kMost; ++k) {
        const OctetMask here = and_not(result.are_there[k], left);
        result.low[k] = select(here, certain, result.low[k]);
        result.high[k] = select(here, high, result.high[k]);
        result.are_there[k] = result.are_there[k] | here;
        left = and_not(here, left);
      }
      result.alone = result.alone | left;
      open = and_not(most < OctetChanges::kMost ? crosses & result.are_there[most - 1] : left, open);
      sign = select(crosses, Octet(0.0) - sign, sign);
    }
    certain = select(ends_certain, high, certain);
    is_done = is_done & open;
    const OctetMask halves = and_not(is_done, open);
    if (none(open)) break;
    if (part == kMostParts) {
      result.alone = result.alone | open;
      break;
    }
    right[part].is_waiting = no_lane();
    if (!none(halves)) {
      OctetBernstein<n> l = p, r;
      halve(l, r);
      const Octet middle = Octet(0.5) * (low + high);
      // A left half without a crossing is done at once.
      const OctetMask goes_left = is_some_below(signed_by(l)), skips = and_not(goes_left, halves);
      const OctetMask left = halves & goes_left;
      certain = select(skips & (l[n] * sign > band), middle, certain);
      right[part] = {r, middle, high, left};
      for (int i = 0; i <= n; ++i) p[i] = select(left, l[i], select(skips, r[i], p[i]));
      low = select(skips, middle, low);
      high = select(left, middle, high);
    }
    for (int i = part - 1; i >= 0 && !none(is_done); --i) {
      const OctetMask here = is_done & right[i].is_waiting;
      if (none(here)) continue;
      for (int k = 0; k <= n; ++k) p[k] = select(here, right[i].p[k], p[k]);
      low = select(here, right[i].low, low);
      high = select(here, right[i].high, high);
      right[i].is_waiting = and_not(here, right[i].is_waiting);
      is_done = and_not(here, is_done);
    }
    open = and_not(is_done, open);
    if (none(open)) break;
  }
  return result;
}

/// 1 where x is certainly positive, −1 where it is certainly negative, else 0.
[[nodiscard]] HWY_INLINE Octet sign_of(const Octet& x, const Octet& band) {
  return select(x > band, Octet(1.0), select(x < Octet(0.0) - band, Octet(-1.0), Octet(0.0)));
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
