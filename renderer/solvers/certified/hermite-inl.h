// The certified solver: it finds the first root of F − T on a stretch of a ray, and proves that none lies before it.
//
// On an interval of width h the true values and slopes at its ends give one cubic for the whole sum of fields, in
// Bernstein form
//   b₀ = F₀,  b₁ = F₀ + hF′₀/3,  b₂ = F₁ − hF′₁/3,  b₃ = F₁,
// and the fields' own bounds (RayLanes::remainder) give a band E around it that F cannot leave. So:
//   max b + E < 0                      no root: the hull of the control points holds the cubic;
//   3 min(bⱼ₊₁ − bⱼ) > hE′             F rises strictly: exactly one root if F₁ > 0, none if F₁ < 0;
//   3 max(bⱼ₊₁ − bⱼ) < −hE′            F falls strictly: none if F₀ < 0;
//   otherwise                          halve the interval with a true node; E falls sixteenfold.
// Signs are judged in two ways. Where a ray crosses is judged by the sign of F as computed, beyond the rounding of its
// sum: that is the best guess of the place. That it does not cross is only proved if F keeps its sign however rounding
// has moved F and the positions that it is computed from (Node::doubt); what is in doubt goes the way of undecided
// intervals.
//
// An interval may remain undecided although E has fallen below the rounding of F, or the interval is shorter than the
// tolerance needs, or its ends are neighbouring doubles. It is then split where a skeleton's nearest feature changes,
// because F changes there too beside the core of a hard component. After that, the ranges of the fields may show that F
// stays on its side. If they do not, the interval is searched again with more digits (extended_search.h). If these do
// not decide it either, the cubic is all that can be known: its own first root is taken, and counted as undecided. So
// is the end of a ray whose bound of steps is spent (rays/ray_steps.h). If the settings ask for digits, what is judged
// to cross is searched with more of them too.
//
// A ray that starts on the surface (a shadow, a reflection) knows its root at 0 and divides it out: with b₀ = 0 the
// quotient Q(u) = F/u has the Bernstein coefficients c₀ = hF′₀, c₁ = 3/2 b₂, c₂ = b₃. The interpolant's error R
// vanishes twice at either end, and |R″| ≤ 43 E wherever f is at least C¹ (32 E where it is smooth, 128/3 E by Peano's
// kernel of osc f″, 29 E by that of osc f‴), so |R|/u ≤ 43/2 E min(u, (1 − u)²/u), which the coefficients 0, 14 E, 0
// bound. Rounding δ of F₁ adds u(3 − 2u)δ, that is 0, 3/2 δ, δ; and rounding δ′ of the slopes adds hδ′₀, hδ′₁/2, 0.
// Neither matters for c₀, because the side was determined by its sign: that a tangent ray does not come back at once is
// as certain as for any other ray. Where F″ > 0, that is where 6 min(bⱼ − 2bⱼ₊₁ + bⱼ₊₂) is above its own band, Q rises
// (h²∫ vF″(uv) dv > 0) and has one root, at which the ray is back. No offset is needed, and so there is neither acne
// nor leaks.
//
// The root is polished on the true field by Newton steps that are kept in a bracket, down to the rounding of F itself.
//
// Sherstyuk 1999 (Hermite interpolants along rays); Aydinlilar and Zanni 2023 (forward inclusion, here of third order);
// Farouki and Rajan 1987 (Bernstein form).
#if defined(ISL_RENDERER_SOLVERS_CERTIFIED_HERMITE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CERTIFIED_HERMITE_INL_H_
#undef ISL_RENDERER_SOLVERS_CERTIFIED_HERMITE_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CERTIFIED_HERMITE_INL_H_
#endif

#include "renderer/fields/ray/ray_lanes-inl.h"
#include "renderer/numerics/cubic.h"
#include "renderer/numerics/rounding_of_noise.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/extended_search.h"
#include "renderer/solvers/cells/node-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class HermiteSolver {
 public:
  using Fields = RayLanes;
  using Lengths = Shortest;
  /// h²|F″ − p″| on an interval is no greater than this times E.
  static constexpr double kBendBand = 43;
  /// The band of c₁ of the quotient by a known root, over E.
  static constexpr double kMiddleBand = 14;
  /// No search halves more often, so that steps are left for more digits: searches in scenes of ordinary sizes need a
  /// few hundred, and those whose bounds overflow, or in the very middle of a hard convolution, would take all.
  static constexpr int kMostSplits = 1 << 14;
  /// A ray whose steps are spent still splits so many times in every cell that it meets, so that the best answer known
  /// is that of a coarse search.
  static constexpr int kSplitsOfSpentRay = 32;
  /// The lengths that the driver hands to every solver. `distance`: of t = 0 from the eye.
  [[nodiscard]] static Lengths lengths(const Shortest& shortest, const SolverSettings&, double /*distance*/) {
    return shortest;
  }

  /// `side` is +1 for a ray outside (F < T) and −1 for one inside.
  HermiteSolver(const RayLanes& fields, double side, const Shortest& shortest, RaySteps& steps, TraceCounters& counters)
      : fields_(fields), side_(side), shortest_(shortest), steps_(steps), counters_(counters) {}

  void turn_inside() { side_ = -1; }

  [[nodiscard]] Node node(double t) {
    const FieldAt f = fields_.at(t);
    counters_.field_evaluations += fields_.field_count();
    const double noise = fields_.noise(t, f);
    return {t, side_ * f.value, side_ * f.slope, noise, fields_.slope_noise(f), fields_.doubt(noise, f)};
  }

  /// The first t in (a.t, last.t] where the ray crosses. With `a_is_root` the ray starts on the surface at a.t and
  /// leaves to the side it is on, and that root is not searched for. `any`: only asks whether there is a crossing; t
  /// may be rough. If there is none, `last` is set to its node as the ray is known to arrive there: on its side.
  [[nodiscard]] std::optional<double> first_root(Node a, Node& last, bool a_is_root, bool any) {
    // `ends` holds the right ends of the intervals that are still to be searched, the nearest on top. Each halving adds
    // one. An interval too short to be halved is split at borders of pieces, from the first on, which adds one more.
    least_ = kLeastShare * (last.t - a.t);
    splits_ = passed_ = 0;
    Node ends[kMostHalvings + 1];
    int top = 0;
    ends[0] = last;
    while (top >= 0) {
      const Node& b = ends[top];
      Verdict verdict = judge(a, b, a_is_root, any);
      if (shortest_.digits && is_found(verdict)) {
        verdict = Verdict::undecided;
        shows_crossing_ = true;
      }
      switch (verdict) {
        case Verdict::none:
          a = b;
          a_is_root = false;
          --top;
          break;
        case Verdict::at_start: return a.t;
        case Verdict::one: return any ? b.t : polish(a, b, root_of_rising(a, b));
        case Verdict::back: return polish(a, b, first_in(quotient(a, b).raised(), a, b));
        case Verdict::in_cubic: return root_in_cubic(a, b, a_is_root);
        case Verdict::undecided: {
          int reached = std::max(0, top - passed_);
          ExtendedAnswer answer = reached < top ? farther_answer(a, ends[reached], a_is_root) : ExtendedAnswer{};
          if (!answer.is_certain) {
            reached = top;
            answer = near_answer(a, b, a_is_root);
          }
          // An end so close to a root that no digits at hand tell the sign there hides what comes before it. From a
          // farther one a crossing is seen. Intervals are halved, so the next end is nearly always enough.
          for (int step = 1; !answer.is_certain && reached > 0; step *= 2) {
            reached = std::max(0, reached - step);
            answer = extended_answer(a, ends[reached], a_is_root);
          }
          if (answer.is_certain) top = reached;
          const Node& end = ends[top];
          if (answer.crossing && counts(end)) return answer.crossing;
          // A ray that does not take faint dips passes one as if it touched the surface, and is undecided.
          if (!answer.is_certain || answer.crossing) {
            ++counters_.undecided_steps;
            if (shows_crossing_) return root_in_cubic(a, end, a_is_root);
          }
          a = end;
          // Rounding may show a side that the ray is certainly not on.
          if (answer.is_certain) a.value = std::min(a.value, 0.0);
          a_is_root = false;
          --top;
          break;
        }
        case Verdict::unclear:
          ++splits_;
          static_cast<void>(steps_.take(fields_.steps_of_interval()));
          ends[++top] = node(split_);
          break;
      }
    }
    last = a;
    return std::nullopt;
  }

 private:
  enum class Verdict { none, at_start, one, back, in_cubic, unclear, undecided };
  [[nodiscard]] static bool is_found(Verdict verdict) {
    return verdict == Verdict::one || verdict == Verdict::back || verdict == Verdict::in_cubic;
  }

  [[nodiscard]] Verdict judge(const Node& a, const Node& b, bool a_is_root, bool any) {
    const double h = b.t - a.t;
    // Only a change of sign beyond the rounding is a crossing: a touch is none.
    const bool crossed = b.value > b.noise;
    if (any && crossed) return Verdict::one;
    if (!a_is_root && a.value > a.noise) return Verdict::at_start;
    const double noise = std::max(a.noise, b.noise), slope_noise = std::max(a.slope_noise, b.slope_noise);
    const Remainder e = fields_.remainder(a.t, b.t);
    const Bernstein p = cubic(a, b);
    if (a_is_root) {
      const Quotient c = quotient(a, b);
      const bool leaves = c.c0 <= h * a.slope_noise;
      if (leaves && c.c1 + kMiddleBand * e.value + 1.5 * b.noise + 0.5 * h * b.slope_noise < 0 && c.c2 + b.noise < 0) {
        return Verdict::none;
      }
      const double bend = 6 * std::min(p.b0 - 2 * p.b1 + p.b2, p.b1 - 2 * p.b2 + p.b3);
      if (leaves && crossed && bend > kBendBand * e.value + 12 * b.noise + 6 * h * slope_noise) {
        most_bend_ = most_bend(p, e, b.noise, h * slope_noise);
        return Verdict::back;
      }
    } else {
      if (std::max({p.b0, p.b1, p.b2, p.b3}) + e.value + std::max(a.doubt, b.doubt) < 0) return Verdict::none;
      const double rise = 3 * std::min({p.b1 - p.b0, p.b2 - p.b1, p.b3 - p.b2});
      const double fall = 3 * std::max({p.b1 - p.b0, p.b2 - p.b1, p.b3 - p.b2});
      const double band = h * (e.slope + slope_noise);
      if (rise > band) {
        most_bend_ = most_bend(p, e, noise, h * slope_noise);
        if (crossed) return Verdict::one;
        if (b.value < -b.doubt) return Verdict::none;
      }
      if (fall < -band && a.value < -a.doubt) return Verdict::none;
    }
    const double middle = a.t + 0.5 * h;
    // E must be within the rounding at both ends: what is small beside a value of 10¹⁰⁰ at one end may be large at the
    // other. It is not if the bound overflowed.
    const bool is_exact = e.value <= std::min(a.noise, b.noise);
    // If the cubic is the field up to rounding, halving gains nothing, unless the cubic bulges above the rounding
    // between ends that are below.
    const bool bulges = !a_is_root && !crossed && std::max(p.b1, p.b2) > noise + h * slope_noise;
    if ((!is_exact || bulges) && middle > a.t && middle < b.t) {
      split_ = middle;
      // A grazing ray may be back at once, so where it starts the tolerance does not count.
      const double shortest = a_is_root ? least_ : std::max(least_, shortest_.by_tolerance);
      const bool may_split = splits_ < (steps_.is_spent() ? kSplitsOfSpentRay : kMostSplits);
      if (h > shortest && may_split) return Verdict::unclear;
      if (const std::optional<double> border = fields_.border_within(a.t, b.t); border && may_split) {
        split_ = *border;
        return Verdict::unclear;
      }
    }
    const Bernstein known = a_is_root ? quotient(a, b).raised() : p;
    // If the cubic is the field, one change of sign among its coefficients, whatever rounding does to them, means
    // one root (variation diminishes). This finds the root of an exact piece that begins flat, and of a grazing ray
    // that is back at once.
    if (is_exact && crossed) {
      const double band = (a_is_root ? kMiddleBand : 1) * e.value + noise + h * slope_noise;
      if (known.b0 < -band && known.b3 > band && !(known.b1 > -band && known.b2 < band)) return Verdict::in_cubic;
    }
    if (!crossed && !a_is_root && stays_on_side(a.t, b.t)) return Verdict::none;
    ++counters_.uncertified_steps;
    // If the ends agree, a cubic that is the field but for rounding may still show a crossing and one back. One that is
    // not, as through the very middle of a hard component, shows nothing.
    shows_crossing_ = crossed || (is_exact && first_crossing_of_cubic(known.b0 - noise, known.b1 - noise,
                                                                      known.b2 - noise, known.b3 - noise) <= 1);
    return Verdict::undecided;
  }

  /// True if a crossing before `end` is one, as it is not if it is the way into a faint dip that the ray passes.
  [[nodiscard]] bool counts(const Node& end) const { return end.value > -end.doubt || shortest_.takes_faint_dips; }

  [[nodiscard]] ExtendedAnswer extended_answer(const Node& a, const Node& b, bool a_is_root) const {
    return search_extended(fields_.laid_out(), {a.t, b.t, side_, a_is_root}, steps_);
  }

  // Beside a surface that rounding hides one undecided interval follows the other, up to thousands. So after each that
  // is found to hold nothing a question reaches farther, twice as many halvings as the last and one more. It counts if
  // it finds nothing either, and may take a few times what the last one took.

  [[nodiscard]] ExtendedAnswer near_answer(const Node& a, const Node& b, bool a_is_root) {
    const std::uint64_t before = steps_.taken();
    const ExtendedAnswer answer = extended_answer(a, b, a_is_root);
    passed_ = answer.is_certain && !answer.crossing ? 1 : 0;
    took_ = steps_.taken() - before;
    return answer;
  }
  [[nodiscard]] ExtendedAnswer farther_answer(const Node& a, const Node& b, bool a_is_root) {
    constexpr std::uint64_t kMostTimes = 4;
    RaySteps steps = steps_.part(kMostTimes * took_);
    const ExtendedAnswer answer = search_extended(fields_.laid_out(), {a.t, b.t, side_, a_is_root}, steps);
    steps_.add(steps);
    took_ = std::max(took_, steps.taken());
    if (!answer.is_certain || answer.crossing) return {};
    passed_ = std::min(2 * passed_ + 1, kMostHalvings);
    return answer;
  }

  /// Decides by the fields' ranges alone. It serves in the middle of a hard component, where no cubic fits.
  [[nodiscard]] bool stays_on_side(double t0, double t1) const {
    const FieldRange f = fields_.range(t0, t1);
    return side_ > 0 ? f.high < 0 : f.low > 0;
  }

  struct Bernstein {
    double b0, b1, b2, b3;
  };
  [[nodiscard]] static Bernstein cubic(const Node& a, const Node& b) {
    const double third = (b.t - a.t) * (1.0 / 3);
    return {a.value, a.value + third * a.slope, b.value - third * b.slope, b.value};
  }
  /// An upper bound of h²|F″| on the interval of the cubic. `slope_noise` is that of h F′.
  [[nodiscard]] static double most_bend(const Bernstein& p, const Remainder& e, double noise, double slope_noise) {
    const double of_cubic = 6 * std::max(std::abs(p.b0 - 2 * p.b1 + p.b2), std::abs(p.b1 - 2 * p.b2 + p.b3));
    return of_cubic + kBendBand * e.value + 12 * noise + 6 * slope_noise;
  }
  struct Quotient {
    double c0, c1, c2;

    /// The same polynomial written as a cubic.
    [[nodiscard]] Bernstein raised() const { return {c0, (c0 + 2 * c1) * (1.0 / 3), (2 * c1 + c2) * (1.0 / 3), c2}; }
  };
  /// The cubic divided by its root at a.
  [[nodiscard]] static Quotient quotient(const Node& a, const Node& b) {
    const double h = b.t - a.t;
    return {h * a.slope, 1.5 * (b.value - h * b.slope * (1.0 / 3)), b.value};
  }

  /// The root in an interval that is too short, or too close to rounding, to be certain: the cubic's own root, then two
  /// Newton steps.
  [[nodiscard]] double root_in_cubic(const Node& a, const Node& b, bool a_is_root) {
    double t = first_in(a_is_root ? quotient(a, b).raised() : cubic(a, b), a, b);
    for (int i = 0; i < 2; ++i) {
      const Node n = node(t);
      const double next = t - n.value / n.slope;
      if (!(next > a.t && next <= b.t) || std::abs(n.value) <= n.noise) break;
      t = next;
    }
    return t;
  }

  [[nodiscard]] static double first_in(const Bernstein& p, const Node& a, const Node& b) {
    return a.t + (b.t - a.t) * std::min(1.0, first_crossing_of_cubic(p.b0, p.b1, p.b2, p.b3));
  }
  [[nodiscard]] static double root_of_rising(const Node& a, const Node& b) {
    const Bernstein p = cubic(a, b);
    return a.t + (b.t - a.t) * root_of_rising_cubic(p.b0, p.b1, p.b2, p.b3);
  }

  /// Precondition: a.value ≤ 0 < b.value, with one root between; t is a first guess. Newton's method on the true field
  /// inside the bracket, until F is within its rounding or will be after the next step: a Newton step s leaves F at
  /// F″s²/2, and most_bend_ bounds h²|F″| between a and b. At a point where F is within its rounding any other step is
  /// left out: if the ray grazes the surface, the slope may be smaller than its rounding error, and the step
  /// meaningless.
  [[nodiscard]] double polish(Node a, Node b, double t) {
    const double half_bend = 0.5 * most_bend_ / ((b.t - a.t) * (b.t - a.t));
    double last = std::numeric_limits<double>::infinity();  // the last of consecutive Newton steps
    // Bisection alone would need 64 steps. Newton steps, once they contract, take three or four.
    for (int i = 0; i < kMostHalvings; ++i) {
      t = std::clamp(t, a.t, b.t);
      const Node n = node(t);
      (n.value > 0 ? b : a) = n;
      double next = t - n.value / n.slope;
      const double size = std::abs(next - t);
      const bool is_within = next > a.t && next < b.t;
      if (is_within && half_bend * size * size <= kRoundingOfNoise * n.noise) return next;
      if (std::abs(n.value) <= n.noise) return t;
      // If F has an inflection in the bracket, Newton's method may alternate between two points for ever. So a step
      // that is more than half as long as the last one is replaced by a halving of the bracket.
      if (is_within && size <= 0.5 * last) {
        last = size;
      } else {
        last = std::numeric_limits<double>::infinity();
        next = a.t + 0.5 * (b.t - a.t);
      }
      if (next == t || !(next > a.t && next < b.t)) return t;
      t = next;
    }
    return t;
  }

  const RayLanes& fields_;
  double side_;
  Shortest shortest_;
  double least_ = 0;             ///< the shortest intervals of the current search
  int passed_ = 0;               ///< how many ends the next question of more digits passes
  std::uint64_t took_ = 0;       ///< the steps of the last one
  int splits_ = 0;               ///< how often the current search has split an interval
  double split_ = 0;             ///< where to split an interval that was judged unclear
  double most_bend_ = 0;         ///< an upper bound of h²|F″| on the interval that was judged to have one root
  bool shows_crossing_ = false;  ///< what the cubic shows on an interval that was judged undecided
  RaySteps& steps_;
  TraceCounters& counters_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
