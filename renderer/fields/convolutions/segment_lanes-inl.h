// Eight convolved segments along a ray, in support radii: the foot of the point on the segment's line lies x_a(t)
// beyond the first end and x_b(t) before the second (x_a + x_b = L), at a squared distance ρ² = n₀ + n₂(t − tₙ)².
//
// An end is within the support where |p − end|² = ρ² + x² < 1: a quadratic of t whose greatest value on a stretch is at
// one of its ends and whose least is there too or, where e = (p − end)·D changes sign, |p − end|² − e²/D². If an end
// stays outside, the part ends at the support's border instead, at W = √(1 − ρ²) from the foot; there e = n₂(t − tₙ) ∓
// W x′. Where the support cuts both sides throughout, f depends on ρ² alone, so the motion along the segment can be
// left out of the bounds: D² = n₂ and x′ = 0.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_LANES_INL_H_
#endif

#include "renderer/fields/convolutions/curve_point-inl.h"
#include "renderer/fields/convolutions/curve_remainder-inl.h"
#include "renderer/fields/convolutions/segment_cauchy-inl.h"
#include "renderer/fields/convolutions/segment_quartic-inl.h"
#include "renderer/fields/skeletons/ray_form-inl.h"
#include "renderer/fields/skeletons/segment.h"

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct SegmentLanes {
  static constexpr std::size_t kAlong = 6, kShape = 1;
  Octet before0, behind0, dx;  ///< x_a = before0 + dx t, x_b = behind0 − dx t
  Octet n0, n2, middle;
  Octet length, amplitude;

  template <class N>
  [[nodiscard]] static HWY_INLINE std::array<N, kAlong> along(const Segment& segment, double per_unit,
                                                              const Lines<N>& lines) {
    const AboutAxis<N> from_a = about_axis(segment.a, segment.axis, lines);
    const AboutAxis<N> from_b = about_axis(segment.a + segment.axis * segment.length, segment.axis, lines);
    // ρ is computed from the nearer end: the distance of the farther one would cost digits.
    const auto nearer_a = abs(from_a.x0) < abs(from_b.x0);
    const N unit(per_unit), unit2 = unit * unit;
    return {from_a.x0 * unit,
            (N(0.0) - from_b.x0) * unit,
            select(nearer_a, from_a.dx, from_b.dx) * unit,
            select(nearer_a, from_a.n0, from_b.n0) * unit2,
            select(nearer_a, from_a.n2, from_b.n2) * unit2,
            select(nearer_a, from_a.middle, from_b.middle)};
  }
  [[nodiscard]] static std::array<double, kShape> shape(const Segment& segment, double unit) {
    return {segment.length * unit};
  }
  static constexpr std::array<double, kAlong + kShape> kOutOfReach = {0.5, 0.5, 1, 4, 0, 0, 1};

  /// |D|.
  [[nodiscard]] HWY_INLINE Octet speed() const { return sqrt(dx * dx + n2); }

  template <class Window>
  [[nodiscard]] HWY_INLINE CurvePoint at(const Window& window, const Octet& t, const Octet& size) const {
    const Octet two(2.0), tau = t - middle, rise = n2 * tau, rho2 = n0 + rise * tau;
    const Chord<Octet> chord = chord_of(rho2, before0 + dx * t, behind0 - dx * t, Octet(0.5) * length);
    const SegmentIntegrals<Octet> f = integrate(window, chord);
    const OctetMask active = (rho2 < Octet(1.0)) & (chord.half_length > Octet(0.0));
    const Octet weight = abs(amplitude), steepest = sqrt(rho2) * abs(f.across) + abs(f.along);  // ½|∇f| and more
    return {keep(active, amplitude * f.value), keep(active, two * amplitude * (dx * f.along - rise * f.across)),
            keep(active, weight * f.value_terms),
            keep(active, two * weight * (abs(dx) * f.along_terms + abs(rise) * f.across_terms)),
            keep(active, two * weight * size * steepest)};
  }

  /// Upper bound of the value on the stretch, for amplitude 1, the lesser of two: the value at the least ρ for a
  /// segment that extends to both sides as far as it does at any t; and the length times the window at the least
  /// distance. Positions may be off by `error`.
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet most(const Window& window, const Octet& t0, const Octet& t1,
                                      const Octet& error) const {
    const Ranges r = ranges(t0, t1, error);
    const Octet zero(0.0);
    const Chord<Octet> chord =
        chord_of(r.rho2_low, r.before_high, r.behind_high, Octet(0.5) * (r.before_high + r.behind_high));
    const OctetMask counts = (r.y_least() < Octet(1.0)) & (chord.half_length > zero);
    const SegmentIntegrals<Octet> f = integrate(window, chord);
    return keep(counts,
                min(f.value + Octet(0x1p-48) * f.value_terms, length * window.value(r.y_least()) * Octet(1 + 0x1p-48)));
  }

  /// Lower bound likewise, the greater of two: the value at the greatest ρ for a segment that extends to both sides as
  /// little as it does at any t; and the length times the window at the greatest distance, which is that of an end.
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet least(const Window& window, const Octet& t0, const Octet& t1,
                                       const Octet& error) const {
    const Ranges r = ranges(t0, t1, error);
    const Octet zero(0.0), one(1.0), rho = sqrt(r.rho2_high) + error, rho2 = rho * rho;
    const Octet before = min(r.before0, r.before1) - error, behind = min(r.behind0, r.behind1) - error;
    const Chord<Octet> chord = chord_of(rho2, before, behind, Octet(0.5) * (before + behind));
    const SegmentIntegrals<Octet> f = integrate(window, chord);
    const Octet at_foot = keep((rho2 < one) & (chord.half_length > zero), f.value - Octet(0x1p-48) * f.value_terms);
    const Octet end = max(max(r.before_high, r.behind_high), zero - min(before, behind)), y = rho2 + end * end;
    return max(at_foot, keep(y < one, length * window.value(y) * Octet(1 - 0x1p-48)));
  }

  [[nodiscard]] HWY_INLINE CurveStretch stretch(const Octet& t0, const Octet& t1) const {
    const Octet zero(0.0), one(1.0);
    const Ranges r = ranges(t0, t1, zero);
    const Octet width2_low = one - r.rho2_high, reach = sqrt(max(one - r.rho2_low, zero));
    const Octet least_reach = sqrt(max(width2_low, zero));
    const Octet rise0 = n2 * (t0 - middle), rise1 = n2 * (t1 - middle);  // ascending

    const Octet speed2 = dx * dx + n2;
    // At the two ends e is n₂τ + x_a x′ and n₂τ − x_b x′.
    const EndRange a = end_range(r.rho2_0 + r.before0 * r.before0, r.rho2_1 + r.before1 * r.before1,
                                 rise0 + r.before0 * dx, rise1 + r.before1 * dx, speed2);
    const EndRange b = end_range(r.rho2_0 + r.behind0 * r.behind0, r.rho2_1 + r.behind1 * r.behind1,
                                 rise0 - r.behind0 * dx, rise1 - r.behind1 * dx, speed2);
    const OctetMask cut_through = (a.low >= one) & (b.low >= one) & (width2_low > zero);
    const Octet along = select(cut_through, zero, dx);

    CurveStretch result;
    result.y_least = r.y_least();
    result.speed2 = n2 + along * along;
    result.tangent = abs(along);
    result.spread = one;
    const Octet to_a = min(r.before_high, reach), to_b = min(r.behind_high, reach);
    result.length = max(zero, min(length, to_a + to_b));
    // e = n₂τ − v x′ for v from −to_a to to_b, and no more than |D| times the distance, which is below 1.
    const Octet shift0 = zero - to_b * along, shift1 = to_a * along;
    const Octet e_low = rise0 + min(shift0, shift1), e_high = rise1 + max(shift0, shift1);
    const Octet e = max(abs(e_low), abs(e_high));
    result.e2 = min(e * e, result.speed2);
    const auto cut = [&](const EndRange& end, double side) HWY_ATTR {
      const Octet near = Octet(side) * least_reach * along, far = Octet(side) * reach * along;
      const Octet most = sqrt(result.speed2);
      return CutBounds{end.high >= one,
                       (end.high < one) | (end.low >= one),
                       width2_low,
                       max(rise0 + min(near, far), zero - most),
                       min(rise1 + max(near, far), most),
                       one};
    };
    result.cuts[0] = cut(a, 1);
    result.cuts[1] = cut(b, -1);
    return result;
  }

 private:
  struct Ranges {
    Octet rho2_0, rho2_1, rho2_low, rho2_high;
    Octet before0, before1, behind0, behind1, before_high, behind_high;

    /// Least squared distance to the segment, from below.
    [[nodiscard]] HWY_INLINE Octet y_least() const {
      const Octet beyond = max(Octet(0.0), Octet(0.0) - min(before_high, behind_high));
      return rho2_low + beyond * beyond;
    }
  };
  [[nodiscard]] HWY_INLINE Ranges ranges(const Octet& t0, const Octet& t1, const Octet& error) const {
    Ranges r;
    const Octet a = t0 - middle, b = t1 - middle;
    const Octet near = max(Octet(0.0), max(a, Octet(0.0) - b));
    r.rho2_0 = n0 + n2 * a * a;
    r.rho2_1 = n0 + n2 * b * b;
    const Octet rho_low = max(Octet(0.0), sqrt(n0 + n2 * near * near) - error);
    r.rho2_low = rho_low * rho_low;
    r.rho2_high = max(r.rho2_0, r.rho2_1);
    r.before0 = before0 + dx * t0;
    r.before1 = before0 + dx * t1;
    r.behind0 = behind0 - dx * t0;
    r.behind1 = behind0 - dx * t1;
    r.before_high = max(r.before0, r.before1) + error;
    r.behind_high = max(r.behind0, r.behind1) + error;
    return r;
  }

  struct EndRange {
    Octet low, high;  ///< range of |p − end|²
  };
  [[nodiscard]] static HWY_INLINE EndRange end_range(const Octet& y0, const Octet& y1, const Octet& e0, const Octet& e1,
                                                     const Octet& speed2) {
    const OctetMask passes = (e0 < Octet(0.0)) & (e1 > Octet(0.0));
    const Octet ends = min(y0, y1);
    return {select(passes, min(ends, y0 - e0 * e0 / speed2), ends), max(y0, y1)};
  }
};

template <>
struct CurveFormOf<Segment> {
  using type = SegmentLanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
