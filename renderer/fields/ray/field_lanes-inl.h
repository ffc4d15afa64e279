// The fields of one cell in the layout of the inner loops. They are set up once for a stretch of a ray, and then give
// value, slope, curvature and bounds at any t or interval in it. Set-up drops fields that cannot reach the stretch. The
// lanes hold eight fields along one ray (RayLanes) or eight rays, for one field after another (PacketLanes), as the
// template's parameter says.
#if defined(ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#endif

#include "renderer/fields/branches.h"
#include "renderer/fields/laid_out_fields.h"
#include "renderer/fields/ray/lane_range-inl.h"
#include "renderer/fields/ray/lane_slope-inl.h"
#include "renderer/fields/ray/lane_values-inl.h"
#include "renderer/fields/ray/lane_walk-inl.h"
#include "renderer/rays/ray_steps.h"

#include <cstdint>
#include <optional>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Setup lays the fields out: LaneSetup or PacketSetup. Its Number is the type of a result: a double for one ray, an
/// octet for eight.
template <class Setup>
class FieldLanes {
 public:
  using Number = typename Setup::Number;

  /// F − T and its derivative along the ray.
  struct FieldAt {
    Number value, slope;
    Number magnitude, steepness;  ///< Σ|fᵢ| and Σ|fᵢ′|, the scales of the rounding errors of plain fields
    Number moved;                 ///< how much F changes if positions are off by their sizes (PlacedLanes)
    Number slope_terms;           ///< the scale of the rounding error of `slope`; a convolution's exceeds its slope
  };
  /// Bounds of the error of F's cubic Hermite interpolant p over an interval: |F − p| ≤ value, |F′ − p′| ≤ slope.
  struct Remainder {
    Number value, slope;
  };

  explicit FieldLanes(LaneMemory& memory) : m_(memory) {}

  /// Gathers the fields of a cell's list that reach the stretch; `where` are the setup's arguments: the ray or rays and
  /// their stretches.
  template <class... Where>
  void set_up(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const Where&... where) {
    sums_ = Setup(m_, where...).gather_list(table, items, count);
    keep(table, items, count, where...);
    threshold_ = table.threshold;
    const Number terms = Number(sums_.field_count) + Number(16.0);
    relative_noise_ = Number(0x1p-52) * (terms + Number(2 * sums_.exponent));
    threshold_noise_ = Number(0x1p-52) * terms * Number(abs(threshold_));
  }

  [[nodiscard]] bool is_empty() const { return m_.runs.empty(); }
  /// Number of fields that reach the stretch, for each ray.
  [[nodiscard]] HWY_INLINE const auto& field_count() const { return sums_.field_count; }
  /// The number of steps that it takes to split an interval and judge its halves (rays/ray_steps.h).
  [[nodiscard]] std::uint64_t steps_of_interval() const {
    return kStepsOfInterval + kStepsOfRow * (m_.runs.empty() ? 0 : m_.runs.back().last);
  }
  /// For packets: those of PacketSums.
  [[nodiscard]] HWY_INLINE const auto& rising_until() const { return sums_.rising_until; }
  [[nodiscard]] HWY_INLINE const auto& falling_from() const { return sums_.falling_from; }
  /// Upper bound of F − T on the stretch.
  [[nodiscard]] HWY_INLINE Number upper_bound() const {
    return sums_.peak * (Number(1.0) + relative_noise_) - Number(threshold_) + threshold_noise_ +
           Number(kPositionError) * sums_.moved;
  }
  /// Bounds of the rounding errors of value and slope at t. For a sum of n fields the error is 2⁻⁵² Σ|fᵢ|(n + 16 + 2v)
  /// + 2⁻⁵²(n + 16)T, where 2v is there because the exponential magnifies the error of its argument v. The error of the
  /// position is four half units in the last place of t.
  [[nodiscard]] HWY_INLINE Number noise(const Number& t, const FieldAt& f) const {
    return relative_noise_ * f.magnitude + threshold_noise_ + Number(0x1p-51) * abs(t) * f.steepness;
  }
  /// The least that noise() can be where F is the threshold, since the fields' values there sum to it.
  [[nodiscard]] HWY_INLINE Number least_noise() const {
    return relative_noise_ * Number(abs(threshold_)) + threshold_noise_;
  }
  /// The same bound with the rounding errors of positions within the components. The value's own sign is the best guess
  /// of where a ray crosses, but that it does not cross must hold for every value within this.
  [[nodiscard]] HWY_INLINE Number doubt(const Number& noise, const FieldAt& f) const {
    return noise + Number(kPositionError) * (sums_.moved + f.moved);
  }
  [[nodiscard]] HWY_INLINE Number slope_noise(const FieldAt& f) const { return relative_noise_ * f.slope_terms; }

  [[nodiscard]] HWY_INLINE FieldAt at(const Number& t) const {
    ValuesAt values{Octet(t)};
    visit_lanes(m_, values);
    const FieldSums& sums = values.sums;
    const Number steepness = total(sums.steepness);
    return {
        total(sums.value) - Number(threshold_), total(sums.slope), total(sums.magnitude), steepness, total(sums.moved),
        steepness + total(sums.slope_excess)};
  }

  /// F″ at t (one-sided where a border of a support or of a piece falls on t).
  [[nodiscard]] Number curvature(const Number& t) const {
    CurvatureAt curvature{Octet(t)};
    visit_lanes(m_, curvature);
    return total(curvature.sum);
  }

  [[nodiscard]] HWY_INLINE Remainder remainder(const Number& t0, const Number& t1) const {
    RemaindersOn remainders{Octet(t0), Octet(t1)};
    visit_lanes(m_, remainders);
    return {total(remainders.sums.value), total(remainders.sums.slope)};
  }

  // ---- For packets only ---------------------------------------------------------------------------------------------

  /// Takes out all fields, so that rays may be adopted.
  void clear() { m_.runs.clear(); }
  /// True if rays of that layout may be adopted: all its fields are points of one group, as are those here.
  [[nodiscard]] bool may_adopt(const FieldLanes& from) const {
    const std::vector<LaneRun>&own = m_.runs, &runs = from.m_.runs;
    return runs.size() == 1 && runs[0].form == LaneForm::points && (own.empty() || own[0].kernel == runs[0].kernel);
  }
  /// Adds the fields of these rays as they are laid out there, the n-th field of each ray to the n-th row. So rays that
  /// meet different cells can be searched together. A ray may be adopted once.
  HWY_INLINE void adopt(const FieldLanes& from, const OctetMask& rays) {
    const LaneRun& run = from.m_.runs[0];
    if (m_.runs.empty()) {
      m_.runs.push_back(run);
      m_.runs[0].last = 0;
      threshold_ = from.threshold_;
    }
    m_.reserve(run.last);
    std::uint32_t& rows = m_.runs[0].last;
    for (; rows < run.last; ++rows) put_beyond(run, m_.rows[rows]);
    const auto replace = [&](const double(&x)[kOctet], double(&of)[kOctet])
                             HWY_ATTR { store(select(rays, load(x), load(of)), of); };
    for (std::uint32_t i = 0; i < run.last; ++i) {
      const LaneRow& row = from.m_.rows[i];
      LaneRow& own = m_.rows[i];
      for (std::size_t k = 0; k < QuadraticLanes::kAlong; ++k) replace(row.along[k], own.along[k]);
      replace(row.shape[kPointSpread], own.shape[kPointSpread]);
      replace(row.amplitude, own.amplitude);
    }
    sums_.adopt(from.sums_, rays);
    relative_noise_ = select(rays, from.relative_noise_, relative_noise_);
    threshold_noise_ = select(rays, from.threshold_noise_, threshold_noise_);
  }

  /// The first t behind t0 at which each ray comes in where a component alone is the threshold; infinite if there is
  /// none. It is not asked for where many fields overlap: there no component has a surface alone.
  [[nodiscard]] HWY_INLINE Octet first_alone(const Octet& t0) const {
    const Octet infinity(std::numeric_limits<double>::infinity());
    Octet first = infinity;
    constexpr std::uint32_t kMostRows = 8;
    if (m_.runs.back().last > kMostRows) return infinity;
    for (const LaneRun& run : m_.runs) {
      const bool are_points = run.form == LaneForm::points;
      if (!(are_points || run.form == LaneForm::pieces) || !(run.surface_alone > 0)) continue;
      const Octet surface(run.surface_alone);
      for (std::uint32_t i = run.first; i < run.last; ++i) {
        const QuadraticLanes lane = load_lanes<QuadraticLanes>(m_.rows[i]);
        const Octet room = surface - lane.v0, t = lane.middle - sqrt(room / lane.kappa);
        const OctetMask is_there = (room > Octet(0.0)) & (t > t0);
        first = select(are_points ? is_there : borders_of(m_.rows[i]).holds(is_there, t), min(first, t), first);
      }
    }
    return first;
  }

  // ---- For one ray only ---------------------------------------------------------------------------------------------

  /// The list and the ray of the last set_up.
  [[nodiscard]] const LaidOutFields& laid_out() const { return laid_out_; }

  /// The first t between these two at which a component's nearest feature changes, where F″ may jump; nothing if there
  /// is none.
  [[nodiscard]] std::optional<double> border_within(double t0, double t1) const {
    double first = t1;
    for (const LaneRun& run : m_.runs) {
      if (run.form != LaneForm::pieces) continue;
      for (std::uint32_t i = run.first; i < run.last; ++i) {
        for (const std::size_t column : {kPieceBegin, kPieceEnd}) {
          for (const double border : m_.rows[i].along[column]) {
            if (border > t0 && border < first) first = border;
          }
        }
      }
    }
    return first < t1 ? std::optional(first) : std::nullopt;
  }
  /// An enclosure of F − T on [t0, t1] (lane_range-inl.h).
  [[nodiscard]] HWY_NOINLINE FieldRange range(double t0, double t1) const {
    const SumRange f = total_of(LaneRange(t0, t1));
    return {f.low - relative_noise_ * f.low_terms - threshold_ - threshold_noise_,
            f.high + relative_noise_ * f.high_terms - threshold_ + threshold_noise_};
  }
  /// Enclosures of F′ (lane_slope-inl.h) and of F″ (lane_bend-inl.h; rounding is not included).
  [[nodiscard]] HWY_NOINLINE FieldRange slope_range(double t0, double t1) const {
    const SumRange f = total_of(LaneSlope(t0, t1));
    return {f.low - relative_noise_ * f.low_terms, f.high + relative_noise_ * f.high_terms};
  }
  [[nodiscard]] HWY_NOINLINE FieldRange bend_range(double t0, double t1) const { return total_of(LaneBend(t0, t1)); }

 private:
  /// Fills a row with a point that no ray reaches.
  static HWY_INLINE void put_beyond(const LaneRun& run, LaneRow& row) {
    const Octet zero(0.0);
    store(Octet(2 * run.kernel->support), row.along[0]);
    for (std::size_t k = 1; k < QuadraticLanes::kAlong; ++k) store(zero, row.along[k]);
    store(zero, row.shape[kPointSpread]);
    store(zero, row.amplitude);
  }
  HWY_INLINE void keep(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const Vec3& origin,
                       const Vec3& direction, double /*t0*/, double /*t1*/) {
    laid_out_ = {&table, items, count, origin, direction};
  }
  template <class... Where>
  HWY_INLINE void keep(const ComponentTable&, const std::uint32_t*, std::uint32_t, const Where&...) {}

  [[nodiscard]] static HWY_INLINE Number total(const Octet& x) { return Setup::total(x); }

  template <class Bounds>
  [[nodiscard]] HWY_INLINE auto total_of(Bounds bounds) const {
    visit_lanes(m_, bounds);
    return bounds.total();
  }

  LaneMemory& m_;
  double threshold_ = 0;
  typename Setup::Sums sums_;
  Number relative_noise_, threshold_noise_;
  LaidOutFields laid_out_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
