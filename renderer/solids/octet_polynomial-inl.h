// The crossings of eight lines with a polynomial of order 3 or 4. The formulas are those of polynomial.cpp and
// line_polynomial.h, operation by operation.
#if defined(ISL_RENDERER_SOLIDS_OCTET_POLYNOMIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_POLYNOMIAL_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_POLYNOMIAL_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_POLYNOMIAL_INL_H_
#endif

#include "renderer/solids/line_polynomial.h"
#include "renderer/solids/octet_roots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// As LinePart.
struct OctetPart {
  OctetVector centre, half;
  Octet w;
};

/// As PowerForm.
template <int n>
class OctetPowers {
 public:
  HWY_NOINLINE OctetPowers(const PreparedPolynomial& polynomial, const OctetPart& part) {
    Octet powers_of_w[n + 1];
    powers_of_w[0] = Octet(1.0);
    for (int k = 1; k <= n; ++k) powers_of_w[k] = powers_of_w[k - 1] * part.w;
    const double* coefficient = polynomial.coefficients.data();
    Sum in_x;
    for (int i = 0; i <= n; ++i) {
      Sum in_y;
      for (int j = 0; j <= i; ++j) {
        Sum in_z;
        for (int k = 0; k <= j; ++k) {
          in_z.multiply(part.centre.z, part.half.z);
          if (const double c = *coefficient++; c != 0) in_z.add(Octet(c) * powers_of_w[k]);
        }
        in_y.multiply(part.centre.y, part.half.y);
        in_y.add(in_z);
      }
      in_x.multiply(part.centre.x, part.half.x);
      in_x.add(in_y);
    }
    for (int k = 0; k <= n; ++k) a_[k] = in_x.c[k];
  }

  [[nodiscard]] HWY_INLINE OctetBernstein<n> on_part() const {
    OctetBernstein<n> b;
    b[0] = a_[n];
    for (int m = 1; m <= n; ++m) {
      const Octet& a = a_[n - m];
      b[m] = b[m - 1] + a;
      for (int i = m - 1; i > 0; --i) b[i] = b[i - 1] - b[i] + a * Octet(binomial(m, i));
      b[0] = a - b[0];
    }
    for (int i = 1; i < n; ++i) b[i] = b[i] / Octet(binomial(n, i));
    return b;
  }
  [[nodiscard]] HWY_INLINE OctetBernstein<n> from_infinity(double sign) const {
    OctetBernstein<n> b;
    for (int k = 0; k <= n; ++k) b[n - k] = sign < 0 && k % 2 != 0 ? Octet(0.0) - a_[k] : a_[k];
    for (int k = 1; k < n; ++k) b[k] = b[k] / Octet(binomial(n, k));
    for (int row = 1; row <= n; ++row) {
      for (int i = n; i >= row; --i) b[i] = b[i] + b[i - 1];
    }
    return b;
  }

 private:
  /// As PowerForm::FixedSum.
  struct Sum {
    bool is_zero = true;
    Octet c[n + 1];

    HWY_INLINE Sum() {
      for (Octet& one : c) one = Octet(0.0);
    }
    HWY_INLINE void multiply(const Octet& constant, const Octet& slope) {
      if (is_zero) return;
      for (int k = n; k > 0; --k) c[k] = constant * c[k] + slope * c[k - 1];
      c[0] = constant * c[0];
    }
    HWY_INLINE void add(const Octet& value) {
      c[0] = c[0] + value;
      is_zero = false;
    }
    HWY_INLINE void add(const Sum& other) {
      if (other.is_zero) return;
      for (int k = 0; k <= n; ++k) c[k] = c[k] + other.c[k];
      is_zero = false;
    }
  };

  Octet a_[n + 1];
};

template <int n>
[[nodiscard]] HWY_INLINE Octet largest_terms(const PreparedPolynomial& polynomial, const OctetPart& part) {
  const Octet x = abs(part.centre.x) + abs(part.half.x), y = abs(part.centre.y) + abs(part.half.y),
              z = abs(part.centre.z) + abs(part.half.z);
  Octet powers_of_w[n + 1];
  powers_of_w[0] = Octet(1.0);
  for (int k = 1; k <= n; ++k) powers_of_w[k] = powers_of_w[k - 1] * part.w;
  const double* coefficient = polynomial.coefficients.data();
  Octet in_x(0.0);
  for (int i = 0; i <= n; ++i) {
    Octet in_y(0.0);
    for (int j = 0; j <= i; ++j) {
      Octet in_z(0.0);
      for (int k = 0; k <= j; ++k) in_z = in_z * z + Octet(std::abs(*coefficient++)) * powers_of_w[k];
      in_y = in_y * y + in_z;
    }
    in_x = in_x * x + in_y;
  }
  return in_x;
}

/// As Stretch, of eight lines.
struct OctetStretch {
  Octet from, to, wanted_to;
};

/// Precondition: the polynomial is of this order.
template <int order>
class OctetPolynomial {
 public:
  /// Finds the first `most` crossings beyond t = 0. Those may be left out that boundary() may leave out.
  HWY_INLINE OctetPolynomial(const PreparedPolynomial& polynomial, const OctetLines& lines, const Octet& start_part,
                             const OctetStretch& stretch, std::size_t most)
      : polynomial_(polynomial),
        lines_(lines),
        wanted_to_(stretch.wanted_to),
        most_(most),
        open_((stretch.from < stretch.to) & (stretch.wanted_to > Octet(0.0))),
        deflates_(equal(start_part, Octet(kSide))),
        sign_(0.0) {
    const auto& [origin, direction] = lines_;
    OctetMask is_tiny = no_lane();
    const Octet length = length_of(direction, is_tiny);
    foot_ = (Octet(0.0) - origin.dot(direction)) / direction.dot(direction);
    h_ = max(length_of(point(foot_), is_tiny), Octet(polynomial.reach));
    near_ = h_ / length;
    leave(is_tiny);
    follow_stretch(stretch);
    if (none(open_)) return;
    if (std::isfinite(polynomial.cube)) {
      follow_through_cube();
    } else {
      follow_line();
    }
  }

  [[nodiscard]] HWY_INLINE const OctetRoots& roots() const { return roots_; }

 private:
  using Bernstein = OctetBernstein<order>;

  [[nodiscard]] HWY_INLINE OctetVector point(const Octet& at) const { return lines_.origin + lines_.direction * at; }
  [[nodiscard]] static HWY_INLINE OctetVector divided(const OctetVector& v, const Octet& by) {
    return {v.x / by, v.y / by, v.z / by};
  }

  /// Follows the lines whose stretch is short enough.
  HWY_INLINE void follow_stretch(const OctetStretch& stretch) {
    const Octet zero(0.0);
    const OctetMask is_whole = (deflates_ & (stretch.from > zero)) | (stretch.to >= Octet(kInfinity));
    if (none(and_not(is_whole, open_))) return;
    OctetMask is_tiny = no_lane();
    const OctetVector a = point(stretch.from), b = point(stretch.to);
    const Octet size = max(max(length_of(a, is_tiny), length_of(b, is_tiny)), Octet(polynomial_.reach));
    leave(and_not(is_whole, is_tiny));
    const OctetMask lanes = and_not(is_whole, open_ & (size <= Octet(kMostStretchGrowth) * h_));
    if (none(lanes)) return;
    const OctetPart part = part_between(divided(a, size), divided(b, size), Octet(1.0) / size);
    const Bernstein p = OctetPowers<order>(polynomial_, part).on_part();
    const Octet band = band_of(part);
    const OctetMask is_certain = ((stretch.from <= zero) | (abs(p[0]) > band)) & (abs(p[order]) > band * Octet(order));
    leave(and_not(is_certain, lanes));
    follow(p, band, lanes & open_,
           [&](const Octet& u) HWY_ATTR { return stretch.from + u * (stretch.to - stretch.from); });
    open_ = and_not(lanes, open_);
  }

  [[nodiscard]] static HWY_INLINE OctetPart part_between(const OctetVector& a, const OctetVector& b, const Octet& w) {
    return {(a + b) * Octet(0.5), (b - a) * Octet(0.5), w};
  }

  void follow_through_cube() {
    const Octet zero(0.0), cube(polynomial_.cube);
    const Octet* const origin[] = {&lines_.origin.x, &lines_.origin.y, &lines_.origin.z};
    const Octet* const direction[] = {&lines_.direction.x, &lines_.direction.y, &lines_.direction.z};
    Octet from(0.0), to(kInfinity);
    for (std::size_t i = 0; i < 3; ++i) {
      const Octet a = (zero - cube - *origin[i]) / *direction[i], b = (cube - *origin[i]) / *direction[i];
      leave(equal(*direction[i], zero));
      from = max(from, min(a, b));
      to = min(to, max(a, b));
    }
    open_ = open_ & (from < to);
    if (none(open_)) return;
    sign_ = select(from > zero, Octet(1.0), zero);
    const OctetPart part =
        part_between(divided(point(from), cube), divided(point(to), cube), Octet(1 / polynomial_.cube));
    follow(OctetPowers<order>(polynomial_, part).on_part(), band_of(part), open_,
           [&](const Octet& u) HWY_ATTR { return from + u * (to - from); });
  }

  void follow_line() {
    const Octet zero(0.0), one(1.0);
    const OctetPart part{divided(point(foot_), h_), lines_.direction * (near_ / h_), one / h_};
    const OctetPowers<order> p(polynomial_, part);
    const Octet band = band_of(part), begin = (zero - foot_) / near_;
    if (const OctetMask lanes = open_ & (begin < Octet(-1.0)); !none(lanes)) {
      const Octet first = Octet(-1.0) / begin;
      follow(kept_from(p.from_infinity(-1), first), band, lanes,
             [&](const Octet& u) HWY_ATTR { return foot_ - near_ / (first + u * (one - first)); });
    }
    if (const OctetMask lanes = open_ & (begin < one); !none(lanes)) {
      const Octet from = max(zero, foot_ - near_), to = foot_ + near_;
      follow(kept_from(p.on_part(), Octet(0.5) * (begin + one)), band, lanes,
             [&](const Octet& u) HWY_ATTR { return from + u * (to - from); });
    }
    if (none(open_)) return;
    const Octet last = select(begin > one, one / begin, one);
    Bernstein beyond = p.from_infinity(1);
    for (int i = 0, j = order; i < j; ++i, --j) std::swap(beyond[i], beyond[j]);
    follow(kept_from(beyond, one - last), band, open_,
           [&](const Octet& u) HWY_ATTR { return foot_ + near_ / (last * (one - u)); });
  }

  [[nodiscard]] HWY_INLINE Octet band_of(const OctetPart& part) const {
    return Octet(rounding_on_line(order)) * largest_terms<order>(polynomial_, part);
  }

  /// As keep_from().
  [[nodiscard]] static HWY_INLINE Bernstein kept_from(Bernstein p, const Octet& from) {
    const OctetMask cuts = from > Octet(0.0);
    const Octet rest = Octet(1.0) - from;
    for (int level = 1; level <= order; ++level) {
      for (int i = 0; i <= order - level; ++i) p[i] = select(cuts, p[i] * rest + p[i + 1] * from, p[i]);
    }
    return p;
  }

  template <class TimeAt>
  HWY_INLINE void follow(const Bernstein& p, const Octet& band, OctetMask lanes, const TimeAt& time_at) {
    // Beyond what is wanted only an unknown sign is looked for.
    const OctetMask ended = and_not(equal(sign_, Octet(0.0)), lanes & (time_at(Octet(0.0)) >= wanted_to_));
    open_ = and_not(ended, open_);
    lanes = and_not(ended, lanes);
    const OctetMask deflates = lanes & deflates_, others = and_not(deflates_, lanes);
    deflates_ = and_not(deflates, deflates_);
    if (!none(deflates)) find(over_u(p), band * Octet(order), deflates, time_at);
    if (!none(others)) find(p, band, others, time_at);
  }

  template <int n, class TimeAt>
  HWY_INLINE void find(const OctetBernstein<n>& p, const Octet& band, const OctetMask& lanes, const TimeAt& time_at) {
    const Octet zero(0.0);
    const OctetMask is_first = lanes & equal(sign_, zero);
    sign_ = select(is_first, sign_of(p[0], band), sign_);
    roots_.starts_inside = roots_.starts_inside | (is_first & (sign_ < zero));
    const OctetMask is_known = and_not(equal(sign_, zero), lanes);
    Octet sign = sign_;
    const OctetChanges changes = changes_of(p, band, is_known, most_, sign_);
    leave(and_not(is_known, lanes) | changes.alone);
    for (std::size_t k = 0; k < most_ && !none(changes.are_there[k]); ++k) {
      const OctetMask ended = changes.are_there[k] & (time_at(changes.low[k]) >= wanted_to_);
      open_ = and_not(ended, open_);
      const OctetMask there = changes.are_there[k] & open_;
      if (none(there)) break;
      OctetBernstein<n> falling = p;
      for (Octet& b : falling.b) b = b * sign;
      append(time_at(root_between(falling, changes.low[k], changes.high[k], 0, there)), there);
      sign = zero - sign;
    }
    if (most_ < OctetRoots::kMost) open_ = open_ & equal(roots_.t[most_ - 1], Octet(kInfinity));
  }

  HWY_INLINE void append(const Octet& at, const OctetMask& lanes) {
    OctetMask left = lanes;
    leave(and_not((at > Octet(0.0)) & (at < Octet(kInfinity)), lanes));
    for (Octet& t : roots_.t) {
      const OctetMask here = left & equal(t, Octet(kInfinity));
      t = select(here, at, t);
      left = and_not(here, left);
    }
    leave(left);
  }

  /// Leaves lines that are still open to crossings().
  HWY_INLINE void leave(const OctetMask& lanes) {
    roots_.alone = roots_.alone | (open_ & lanes);
    open_ = and_not(lanes, open_);
  }

  const PreparedPolynomial& polynomial_;
  const OctetLines& lines_;
  Octet wanted_to_;
  std::size_t most_;
  OctetRoots roots_;
  OctetMask open_;      ///< lines that are still followed
  OctetMask deflates_;  ///< the next piece begins with the known root
  Octet sign_;          ///< the last certain sign, or 0
  Octet foot_, h_, near_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
