// The crossings of eight lines with a torus that is no spindle. The formulas are those of torus.cpp, operation by
// operation.
#if defined(ISL_RENDERER_SOLIDS_OCTET_TORUS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_TORUS_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_TORUS_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_TORUS_INL_H_
#endif

#include "renderer/numerics/polynomial_roots.h"
#include "renderer/solids/octet_roots-inl.h"
#include "renderer/solids/torus_search.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class OctetTorus {
 public:
  /// Finds the first `most` crossings.
  HWY_INLINE OctetTorus(const scene::Solid& solid, const OctetLines& lines, const Octet& start_part, std::size_t most)
      : solid_(solid), lines_(lines), starts_on_surface_(equal(start_part, Octet(kSide))), most_(most) {
    const OctetMask meets = set_stretch();
    if (none(meets)) return;
    begin_ = lines.origin + lines.direction * from_;
    const double reach = solid.radius_a + solid.radius_b, largest = 2 * reach * reach;
    const double band = rounding_of_order(4) * largest * largest;
    const OctetBernstein<4> p = quartic(begin_, begin_ + lines.direction * length_);
    const OctetMask deflates = meets & starts_on_surface_, others = and_not(starts_on_surface_, meets);
    if (!none(deflates)) follow(over_u(p), 4 * band, deflates);
    if (!none(others)) follow(p, band, others);
  }

  [[nodiscard]] HWY_INLINE const OctetRoots& roots() const { return roots_; }

 private:
  /// The lines that may meet the torus in t > 0.
  HWY_INLINE OctetMask set_stretch() {
    const auto& [origin, direction] = lines_;
    const Octet zero(0.0), reach(solid_.radius_a + solid_.radius_b), dd = direction.dot(direction);
    const Octet middle = (zero - origin.dot(direction)) / dd;
    OctetMask is_tiny = no_lane();
    const Octet distance = length_of(origin + direction * middle, is_tiny);
    const Octet half = sqrt((reach - distance) * (reach + distance) / dd);
    const Octet a = (Octet(-solid_.radius_b) - origin.y) / direction.y;
    const Octet b = (Octet(solid_.radius_b) - origin.y) / direction.y;
    from_ = max(middle - half, min(a, b));
    const Octet to = min(middle + half, max(a, b));
    outside_ = and_not(starts_on_surface_, from_ > zero);
    from_ = keep(outside_, from_);
    length_ = to - from_;
    roots_.alone = is_tiny | equal(direction.y, zero);
    return and_not(roots_.alone, (distance < reach) & (length_ > zero));
  }

  [[nodiscard]] HWY_INLINE OctetBernstein<4> quartic(const OctetVector& a, const OctetVector& b) const {
    const double big = solid_.radius_a * solid_.radius_a, small = solid_.radius_b * solid_.radius_b;
    const auto square = [&](const Octet& pp) HWY_ATTR { return pp - Octet(big) - Octet(small); };
    const Octet s0 = square(a.dot(a)), s1 = square(a.dot(b)), s2 = square(b.dot(b));
    const Octet y0 = a.y * a.y - Octet(small), y1 = a.y * b.y - Octet(small), y2 = b.y * b.y - Octet(small);
    const Octet two(2.0), four(4 * big), half(4 * big * 0.5);
    OctetBernstein<4> p;
    p[0] = s0 * s0 + four * y0;
    p[1] = s0 * s1 + half * (y0 + y1);
    p[2] = (two * s1 * s1 + s0 * s2) / Octet(3.0) + four * (y0 + Octet(4.0) * y1 + y2) / Octet(6.0);
    p[3] = s1 * s2 + half * (y1 + y2);
    p[4] = s2 * s2 + four * y2;
    return p;
  }

  template <int n>
  HWY_INLINE void follow(const OctetBernstein<n>& p, double band, const OctetMask& lanes) {
    const Octet zero(0.0), before = select(outside_, Octet(1.0), sign_of(p[0], Octet(band)));
    const OctetMask is_known = lanes & (abs(before) > zero);
    Octet sign = before;
    const OctetChanges changes = changes_of(p, Octet(band), is_known, most_, sign);
    OctetMask alone = changes.alone | and_not(is_known, lanes);
    // The sign before each change, for which the polynomial is turned into one that falls.
    sign = before;
    for (std::size_t k = 0; k < most_ && !none(changes.are_there[k]); ++k) {
      const OctetMask& there = changes.are_there[k];
      OctetBernstein<n> falling = p;
      for (Octet& b : falling.b) b = b * sign;
      const Octet &low = changes.low[k], &high = changes.high[k];
      Octet at = root_between(falling, low, high, TorusSearch::kNear, there) * length_;
      const OctetMask is_found = polish(there, at) & (at >= low * length_) & (at <= high * length_);
      alone = alone | and_not(is_found & (from_ + at > zero), there);
      roots_.t[k] = select(there, from_ + at, roots_.t[k]);
      sign = zero - sign;
    }
    // The torus ends within the stretch. If a line seems to be inside at its end, its last crossing was not certain,
    // and crossings() adds it.
    alone = alone | (lanes & ends_inside(before, changes));
    roots_.starts_inside = roots_.starts_inside | (is_known & (before < zero));
    roots_.alone = roots_.alone | alone;
  }

  /// True if the sign behind the last change is that of the inside; always false if not all were wanted.
  [[nodiscard]] HWY_INLINE OctetMask ends_inside(const Octet& before, const OctetChanges& changes) const {
    Octet sign = before;
    for (const OctetMask& there : changes.are_there) sign = select(there, Octet(0.0) - sign, sign);
    const OctetMask is_inside = sign < Octet(0.0);
    return most_ < OctetChanges::kMost ? and_not(changes.are_there[most_ - 1], is_inside) : is_inside;
  }

  /// The lanes in which it converges.
  HWY_INLINE OctetMask polish(OctetMask open, Octet& at) const {
    const OctetVector& direction = lines_.direction;
    const Octet big(solid_.radius_a), small2(solid_.radius_b * solid_.radius_b);
    const Octet shortest = Octet(TorusSearch::kConverged) * length_;
    Octet longest = Octet(TorusSearch::kMoved) * length_;
    OctetMask converged = no_lane();
    for (int step = 0; step < TorusSearch::kMostSteps && !none(open); ++step) {
      const OctetVector p = begin_ + direction * at;
      const Octet rho = sqrt(p.x * p.x + p.z * p.z), across = rho - big;
      const Octet slope = across * (p.x * direction.x + p.z * direction.z) / rho + p.y * direction.y;
      const Octet move = (across * across + p.y * p.y - small2) / (Octet(2.0) * slope), size = abs(move);
      open = open & (size <= longest);
      at = select(open, at - move, at);
      const OctetMask done = open & (size <= shortest);
      converged = converged | done;
      open = and_not(done, open);
      longest = Octet(0.5) * size;
    }
    return converged;
  }

  const scene::Solid& solid_;
  const OctetLines& lines_;
  OctetRoots roots_;
  OctetMask starts_on_surface_, outside_;
  Octet from_, length_;  ///< of the stretch
  OctetVector begin_;
  std::size_t most_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
