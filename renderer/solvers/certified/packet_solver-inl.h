// HermiteSolver (hermite-inl.h) for eight rays in one cell at once, one ray in every lane: the same nodes, the same
// cubic with its band, the same proofs and the same polish. It decides only what a proof decides. Intervals that have
// come down to rounding, or to lengths that the tolerance does not ask to tell apart, go to HermiteSolver. So do rays
// that start on the surface and do not certainly leave outwards.
//
// Most rays meet a surface where all fields of the cell still rise, and there the ends of an interval decide. So the
// first interval ends a little behind where a component alone has its surface.
//
// After an interval that is clear, the next one is longer, above all after one that began at a known root: away from
// the root F is farther from 0. No node is kept for later, because one evaluation serves eight rays.
#if defined(ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SOLVER_INL_H_
#undef ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SOLVER_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SOLVER_INL_H_
#endif

#include "renderer/fields/packet/packet_lanes-inl.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/certified/hermite-inl.h"

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The result of a cell for each of eight rays.
struct PacketRoots {
  std::uint32_t found = 0;      ///< bit i: ray i crosses the surface at t[i]
  std::uint32_t undecided = 0;  ///< bit i: this solver cannot decide ray i
  alignas(64) double t[kPacket];
};

/// The search of a cell for each of eight rays.
struct PacketQuery {
  OctetMask lanes;   ///< the rays to search, which come from outside
  OctetMask starts;  ///< those of them that come from the surface; the root at t0, if there is one, is not searched for
  OctetMask start_here;  ///< those of these that certainly have it: they start at t0
  OctetMask unknown;     ///< those of them that start at t0 on a side that is not known yet
  Octet t0, t1;
  Octet least;  ///< intervals no longer than this are left undecided
  bool any;     ///< only asks whether there is a crossing; none lies before its t, which is no root
};

class PacketSolver {
 public:
  PacketSolver(const PacketLanes& fields, TraceCounters& counters) : fields_(fields), counters_(counters) {}

  /// Finds the first crossings. A ray that starts on the surface is left undecided unless it certainly leaves outwards,
  /// and one whose side is not known unless it certainly starts outside.
  void first_roots(const PacketQuery& query, PacketRoots& roots) {
    roots.found = roots.undecided = 0;
    const Octet &t0 = query.t0, &t1 = query.t1;
    const bool any = query.any;
    searched_ = query.lanes;
    const Octet guess = fields_.first_alone(t0);
    Node a = node(t0), b = node(min(t1, first_end(t0, guess)));
    // The rays whose interval begins at a known root. Those that have left the surface are beyond doubt.
    OctetMask rooted = query.lanes & (query.start_here | and_not(a.value + a.doubt < Octet(0.0), query.starts));
    if (const OctetMask asked = rooted | (query.unknown & query.lanes); !none(asked)) {
      const OctetMask leaves = a.slope < Octet(0.0) - a.slope_noise, is_outside = a.value + a.doubt < Octet(0.0);
      const OctetMask others = and_not((rooted & leaves) | and_not(rooted, is_outside), asked);
      roots.undecided = bits(others);
      searched_ = and_not(others, searched_);
      a.value = select(rooted, Octet(0.0), a.value);
      if (none(searched_)) return;
    }
    Node from = a, to = b;  // the brackets of roots
    Octet bend(0.0);        // the bound of h²|F″| in the brackets
    OctetMask bracketed = no_lane(), found = no_lane();
    Octet root = t0;
    // A search that takes more than 64 halvings and as many steps back hugs the surface, or is better done alone.
    for (int i = 0; i < kMostHalvings; ++i) {
      if (any) {
        const OctetMask across = searched_ & (b.value > b.noise);
        from = select(across, a, from);
        bracketed = bracketed | across;
        searched_ = and_not(across, searched_);
        if (none(searched_)) break;
      }
      const Verdicts verdict = judge(a, b, rooted, query.least);
      if (const OctetMask at_start = searched_ & verdict.at_start; !none(at_start)) {
        root = select(at_start, a.t, root);
        found = found | at_start;
      }
      if (const OctetMask one = searched_ & verdict.one; !none(one)) {
        from = select(one, a, from);
        to = select(one, b, to);
        bend = select(one, verdict.bend, bend);
        bracketed = bracketed | one;
      }
      const OctetMask goes_on = searched_ & verdict.none & (b.t < t1), splits = searched_ & verdict.splits;
      roots.undecided |= bits(searched_ & verdict.undecided);
      searched_ = goes_on | splits;
      if (none(searched_)) break;
      const Octet h = (b.t - a.t) * select(rooted, Octet(kAfterRoot), Octet(kAfterClear));
      a = select(goes_on, b, a);
      rooted = and_not(goes_on, rooted);
      b = node(select(goes_on, min(b.t + h, t1), verdict.split));
    }
    roots.undecided |= bits(searched_);
    if (!none(bracketed)) {
      root = select(bracketed, any ? from.t : polish(bracketed, from, to, bend, guess), root);
      found = found | bracketed;
    }
    roots.found = bits(found);
    store(root, roots.t);
  }

 private:
  /// The length of the interval after one that began at a known root, over the length of that one. Of 1, 2, 4, 8 and
  /// 64, flakes are traced fastest with 4; with 1 they take up to a tenth longer.
  static constexpr double kAfterRoot = 4;
  /// The same after any other clear interval. Of 1, 1.5, 2 and 3, flakes are traced fastest with 1.5, by 1 to 3 %.
  static constexpr double kAfterClear = 1.5;
  /// The least part of an interval that is split off because F rises there.
  static constexpr double kLeastRise = 1.0 / 8;
  /// How far behind a guessed root the first interval ends, as a share of the way there: so that F is certainly above
  /// its noise. Shares from 1/50 to 1/5 take the same time.
  static constexpr double kBeyondGuess = 1.0 / 16;

  struct Node {
    Octet t, value, slope, noise, slope_noise, doubt;
  };
  [[nodiscard]] static HWY_INLINE Node select(const OctetMask& mask, const Node& yes, const Node& no) {
    return {select(mask, yes.t, no.t),
            select(mask, yes.value, no.value),
            select(mask, yes.slope, no.slope),
            select(mask, yes.noise, no.noise),
            select(mask, yes.slope_noise, no.slope_noise),
            select(mask, yes.doubt, no.doubt)};
  }
  [[nodiscard]] static HWY_INLINE Octet select(const OctetMask& mask, const Octet& yes, const Octet& no) {
    return HWY_NAMESPACE::select(mask, yes, no);
  }

  [[nodiscard]] HWY_INLINE Node node(const Octet& t) {
    const PacketLanes::FieldAt f = fields_.at(t);
    counters_.field_evaluations += static_cast<std::uint64_t>(sum(keep(searched_, fields_.field_count())));
    const Octet noise = fields_.noise(t, f);
    return {t, f.value, f.slope, noise, fields_.slope_noise(f), fields_.doubt(noise, f)};
  }

  /// Returns the end of the first interval; it may lie beyond the stretch. With a guess, the interval ends a little
  /// behind the guessed root, but not where a field already falls. Without a guess, it ends at the greatest value of a
  /// sum that first rises and then falls.
  [[nodiscard]] HWY_INLINE Octet first_end(const Octet& t0, const Octet& guess) const {
    const Octet top = fields_.rising_until(), infinity(std::numeric_limits<double>::infinity());
    const Octet beyond = guess + Octet(kBeyondGuess) * (guess - t0);
    const Octet behind_guess = select(top > guess, min(top, beyond), beyond);
    const Octet at_top = select((top > t0) & (fields_.falling_from() <= top), top, infinity);
    return select(guess < infinity, behind_guess, at_top);
  }

  struct Verdicts {
    OctetMask none, at_start, one, splits, undecided;
    Octet split;  ///< where to split the interval
    Octet bend;   ///< an upper bound of h²|F″|
  };

  /// Judges the intervals from a to b, which begin at a known root in the lanes of `rooted`.
  [[nodiscard]] HWY_INLINE Verdicts judge(const Node& a, const Node& b, const OctetMask& rooted,
                                          const Octet& least) const {
    const Octet zero(0.0), three(3.0);
    const Octet h = b.t - a.t, third = h * Octet(1.0 / 3);
    const OctetMask crossed = b.value > b.noise, at_start = and_not(rooted, a.value > a.noise);
    // If no field falls in the interval, or none rises, the signs of F at both ends decide.
    const OctetMask ascends = and_not(rooted, b.t <= fields_.rising_until());
    const OctetMask descends = and_not(rooted, a.t >= fields_.falling_from());
    const OctetMask clear_by_ends =
        and_not(at_start, (ascends & (b.value + b.doubt < zero)) | (descends & (a.value + a.doubt < zero)));
    const OctetMask one_by_ends = and_not(at_start | clear_by_ends, ascends & crossed);
    if (none(and_not(at_start | clear_by_ends | one_by_ends, searched_))) {
      const OctetMask nothing = no_lane();
      return {
          clear_by_ends, at_start, one_by_ends, nothing, nothing, b.t, Octet(std::numeric_limits<double>::infinity())};
    }
    const Octet noise = max(a.noise, b.noise), slope_noise = max(a.slope_noise, b.slope_noise);
    const PacketLanes::Remainder e = fields_.remainder(a.t, b.t);
    const Octet b1 = a.value + third * a.slope, b2 = b.value - third * b.slope;
    const OctetMask below = max(max(a.value, b1), max(b2, b.value)) + e.value + max(a.doubt, b.doubt) < zero;
    const Octet d0 = b1 - a.value, d1 = b2 - b1, d2 = b.value - b2;
    const Octet rise = three * min(d0, min(d1, d2)), fall = three * max(d0, max(d1, d2));
    const Octet band = h * (e.slope + slope_noise);
    const OctetMask rises = and_not(rooted, rise > band) | ascends, falls = (fall < zero - band) | descends;
    OctetMask clear =
        and_not(rooted, below | (falls & (a.value + a.doubt < zero)) | (rises & (b.value + b.doubt < zero)));
    if (!none(rooted)) {
      // The quotient by the known root has the coefficients c₀ = hF′₀ < 0, c₁ = 3/2 b₂ and c₂ = b₃.
      const Octet c1 = Octet(1.5) * b2 + Octet(HermiteSolver::kMiddleBand) * e.value + Octet(1.5) * b.noise +
                       Octet(0.5) * h * b.slope_noise;
      clear = clear | (rooted & (c1 < zero) & (b.value + b.noise < zero));
    }
    const Octet middle = a.t + Octet(0.5) * h;
    const OctetMask may_split = (e.value > min(a.noise, b.noise)) & (h > least) & (middle > a.t) & (middle < b.t);
    Verdicts v;
    v.at_start = at_start;
    v.none = and_not(at_start, clear);
    const OctetMask open = and_not(at_start | clear, all_lanes());
    v.one = open & rises & crossed;
    const OctetMask unclear = and_not(rises & crossed, open);
    v.splits = unclear & may_split;
    // E falls sixteenfold or more with every halving, and a proof needs it to be a small part of F, so the split
    // depends on how far E has to fall.
    const Octet size = max(max(abs(a.value), abs(b.value)), max(abs(b1), abs(b2)));
    const Octet share = select(e.value > Octet(16.0) * size, Octet(0.125), Octet(0.25));
    v.split = a.t + h * select(e.value > size, share, Octet(0.5));
    // Up to where the first field begins to fall the ends decide.
    const Octet top = fields_.rising_until();
    v.split = select((top > a.t + Octet(kLeastRise) * h) & (top < b.t), top, v.split);
    v.bend = Octet(6.0) * max(abs(d1 - d0), abs(d2 - d1)) + Octet(HermiteSolver::kBendBand) * e.value +
             Octet(12.0) * noise + Octet(6.0) * h * slope_noise;
    v.undecided = and_not(may_split, unclear);
    return v;
  }

  /// The root of the rising cubic between a and b, in units of their distance, to a few digits: a first guess for the
  /// true root.
  [[nodiscard]] static HWY_INLINE Octet rising_root(const Node& a, const Node& b) {
    const Octet zero(0.0), one(1.0), third = (b.t - a.t) * Octet(1.0 / 3);
    const Octet b1 = a.value + third * a.slope, b2 = b.value - third * b.slope;
    Octet u = a.value / (a.value - b.value);
    for (int i = 0; i < 3; ++i) {
      const Octet v = one - u;
      const Octet c0 = v * a.value + u * b1, c1 = v * b1 + u * b2, c2 = v * b2 + u * b.value;
      const Octet d0 = v * c0 + u * c1, d1 = v * c1 + u * c2;
      u = max(zero, min(one, u - (v * d0 + u * d1) / (Octet(3.0) * (d1 - d0))));
    }
    return select((u >= zero) & (u <= one), u, Octet(0.5));  // 0/0 is neither
  }

  /// Newton's method on the true fields, from `guess` where that is inside, within brackets a.value ≤ 0 < b.value that
  /// hold one root each. F rises all along, and h²|F″| is at most `bend`. As HermiteSolver::polish.
  [[nodiscard]] HWY_INLINE Octet polish(const OctetMask& lanes, const Node& a, const Node& b, const Octet& bend,
                                        const Octet& guess) {
    const Octet infinity(std::numeric_limits<double>::infinity()), half(0.5);
    searched_ = lanes;
    Octet low = a.t, high = b.t;
    const Octet width = high - low;
    const Octet half_bend = half * bend / (width * width);
    const OctetMask is_guessed = (guess > low) & (guess < high);
    Octet t = guess;
    if (!none(and_not(is_guessed, lanes))) t = select(is_guessed, guess, low + width * rising_root(a, b));
    Octet result = t, last = infinity;
    for (int i = 0; i < kMostHalvings && !none(searched_); ++i) {
      const Node n = node(t);
      const OctetMask above = n.value > Octet(0.0);
      high = select(above, t, high);
      low = select(above, low, t);
      const Octet newton = t - n.value / n.slope, size = abs(newton - t);
      const OctetMask is_within = (newton > low) & (newton < high);
      const OctetMask will_be = is_within & (half_bend * size * size <= Octet(kRoundingOfNoise) * n.noise);
      const OctetMask done = will_be | (abs(n.value) <= n.noise);
      const OctetMask shrinks = is_within & (size <= half * last);
      last = select(shrinks, size, infinity);
      const Octet next = select(will_be, newton, select(done, t, select(shrinks, newton, low + half * (high - low))));
      const OctetMask moves = and_not(done, (next > low) & (next < high) & ((next < t) | (next > t)));
      result = select(searched_, select(moves | done, next, t), result);
      searched_ = searched_ & moves;
      t = next;
    }
    return result;
  }

  const PacketLanes& fields_;
  TraceCounters& counters_;
  OctetMask searched_;  ///< the rays whose evaluations are counted
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
