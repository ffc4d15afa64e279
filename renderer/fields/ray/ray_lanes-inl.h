// The fields of one cell along one ray, side by side in octets: set up once for a stretch of the ray, then asked for
// value, slope, curvature and bounds at any t or interval in it. What cannot reach the stretch is dropped at set-up.
#if defined(ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#endif

#include "renderer/fields/branches.h"
#include "renderer/fields/ray/field_lanes-inl.h"
#include "renderer/fields/ray/lane_range-inl.h"
#include "renderer/fields/ray/lane_setup-inl.h"
#include "renderer/fields/ray/lane_slope-inl.h"
#include "renderer/fields/ray/lane_walk-inl.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// F − T and its derivative along the ray.
struct FieldAt {
  double value, slope;
  double magnitude, steepness;  ///< Σ|fᵢ| and Σ|fᵢ′|: what rounding is relative to
};

/// How far a cubic Hermite interpolant of F may be from F over an interval of width h: |F − p| ≤ value, |F′ − p′| ≤
/// slope.
struct Remainder {
  double value, slope;
};

class RayLanes {
 public:
  explicit RayLanes(LaneMemory& memory) : m_(memory) {}

  /// Gathers the fields of a cell's list that reach t in [t0, t1] (lane_setup-inl.h).
  void set_up(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const Vec3& origin,
              const Vec3& direction, double t0, double t1) {
    sums_ = LaneSetup(m_).gather_list(table, items, count, origin, direction, t0, t1);
    threshold_ = table.threshold;
    relative_noise_ = 0x1p-52 * (sums_.field_count + 16.0 + 2 * sums_.exponent);
    threshold_noise_ = 0x1p-52 * (sums_.field_count + 16.0) * std::abs(threshold_);
  }

  [[nodiscard]] bool is_empty() const { return m_.runs.empty(); }
  [[nodiscard]] std::uint32_t field_count() const { return sums_.field_count; }
  /// No value of F − T on the stretch is greater than this.
  [[nodiscard]] double upper_bound() const {
    return sums_.peak * (1 + relative_noise_) - threshold_ + threshold_noise_;
  }
  /// Bounds of the rounding in the value and the slope at t. That of a sum of n fields is 2⁻⁵² Σ|fᵢ|(n + 16 + 2v) +
  /// 2⁻⁵²(n + 16)T, the exponential magnifying the error of its argument v; that of the position is four half units of
  /// t.
  [[nodiscard]] double noise(double t, const FieldAt& f) const {
    return relative_noise_ * f.magnitude + threshold_noise_ + 0x1p-51 * std::abs(t) * f.steepness;
  }
  [[nodiscard]] double slope_noise(const FieldAt& f) const { return relative_noise_ * f.steepness; }

  [[nodiscard]] FieldAt at(double t) const {
    FieldSums sums;
    for (const LaneRun& run : m_.runs) {
      if (run.kernel->is_convolved) {
        add_curves_at(run, t, sums);
      } else {
        with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR { add_at(kernel, run, t, sums); });
      }
    }
    return {sum(sums.value) - threshold_, sum(sums.slope), sum(sums.magnitude), sum(sums.steepness)};
  }

  /// F″ at t (one-sided where a border of a support or of a piece falls on t).
  [[nodiscard]] double curvature(double t) const {
    Octet total(0.0);
    for (const LaneRun& run : m_.runs) {
      if (run.kernel->is_convolved) {
        total = total + curvature_of_curves(run, t);
        continue;
      }
      with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR { total = total + curvature_of(kernel, run, t); });
    }
    return sum(total);
  }

  [[nodiscard]] Remainder remainder(double t0, double t1) const {
    RemainderSums sums;
    for (const LaneRun& run : m_.runs) {
      if (run.kernel->is_convolved) {
        add_remainder_of_curves(run, t0, t1, sums);
        continue;
      }
      with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR { add_remainder(kernel, run, t0, t1, sums); });
    }
    return {sum(sums.value), sum(sums.slope)};
  }

  /// The first t between these two where a component's nearest feature changes: there F may bend as sharply as it likes.
  [[nodiscard]] std::optional<double> border_within(double t0, double t1) const {
    double first = t1;
    for (const LaneRun& run : m_.runs) {
      if (!run.has_pieces) continue;
      for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; ++i) {
        for (const auto column : {LaneMemory::kBegin, LaneMemory::kEnd}) {
          const double border = m_.quadratic.row(i)[static_cast<std::size_t>(column) * m_.quadratic.stride()];
          if (border > t0 && border < first) first = border;
        }
      }
    }
    return first < t1 ? std::optional(first) : std::nullopt;
  }
  /// F − T on [t0, t1], from outside (lane_range-inl.h).
  [[nodiscard]] FieldRange range(double t0, double t1) const {
    const SumRange f = LaneRange(m_, t0, t1).sum_range();
    return {f.low - relative_noise_ * f.low_terms - threshold_ - threshold_noise_,
            f.high + relative_noise_ * f.high_terms - threshold_ + threshold_noise_};
  }
  /// F′ likewise (lane_slope-inl.h), and F″ (lane_bend-inl.h), rounding apart.
  [[nodiscard]] FieldRange slope_range(double t0, double t1) const {
    const SumRange f = LaneSlope(m_, t0, t1).sum_range();
    return {f.low - relative_noise_ * f.low_terms, f.high + relative_noise_ * f.high_terms};
  }
  [[nodiscard]] FieldRange bend_range(double t0, double t1) const { return LaneBend(m_, t0, t1).range(); }

 private:
  // ---- Evaluation ---------------------------------------------------------------------------------------------------

  [[nodiscard]] HWY_INLINE OctetMask on_piece(const LaneRun& run, std::uint32_t i, const Octet& t,
                                              const OctetMask& mask) const {
    if (!run.has_pieces) return mask;
    return mask & (t >= load_border(m_, i, LaneMemory::kBegin)) & (t < load_border(m_, i, LaneMemory::kEnd));
  }

  template <class Kernel>
  HWY_INLINE void add_at(const Kernel& kernel, const LaneRun& run, double t, FieldSums& sums) const {
    for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
      sums.add(field_at(kernel, load_quadratic(m_, i), Octet(t), [&](const OctetMask& within) HWY_ATTR {
        return on_piece(run, i, Octet(t), within);
      }));
    }
    add_lanes_at(kernel, run, run.cones, load_cone, t, sums);
    add_lanes_at(kernel, run, run.circles, load_circle, t, sums);
  }

  HWY_NOINLINE void add_curves_at(const LaneRun& run, double t, FieldSums& sums) const {
    for_each_curve(m_, run, [&](const auto& window, const auto& lanes) HWY_ATTR {
      sums.add(lanes.at(window, Octet(t)));
    });
  }

  /// Convolved fields are twice differentiable, so the slopes at t ± η tell: with η = 2⁻¹⁷ of the support, where the rounding
  /// of the slopes (2⁻⁵²/η) and the next derivative's share (η²) are both below 2⁻³⁴ of it.
  [[nodiscard]] HWY_NOINLINE Octet curvature_of_curves(const LaneRun& run, double t) const {
    Octet total(0.0);
    for_each_curve(m_, run, [&](const auto& window, const auto& lanes) HWY_ATTR {
      const Octet step = Octet(0x1p-17) / lanes.speed();
      const Octet rise = lanes.at(window, Octet(t) + step).slope - lanes.at(window, Octet(t) - step).slope;
      total = total + Octet(0.5) * rise / step;
    });
    return total;
  }

  HWY_NOINLINE void add_remainder_of_curves(const LaneRun& run, double t0, double t1, RemainderSums& sums) const {
    for_each_curve(m_, run, [&](const auto& window, const auto& lanes) HWY_ATTR {
      sums.add_curves(window, lanes, Octet(t0), Octet(t1));
    });
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_lanes_at(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows, const Load& load_lanes,
                               double t, FieldSums& sums) const {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      sums.add(field_at(kernel, load_lanes(m_, i), Octet(t), run.kernel->scale));
    }
  }

  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet curvature_of(const Kernel& kernel, const LaneRun& run, double t) const {
    Octet total(0.0);
    for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
      const QuadraticLanes lane = load_quadratic(m_, i);
      const Octet tau = Octet(t) - lane.middle;
      const Octet first = Octet(2.0) * lane.kappa * tau;
      const Octet v = lane.v0 + lane.kappa * tau * tau;
      const OctetMask active = on_piece(run, i, Octet(t), v < kernel.support());
      const Octet second =
          kernel.curvature(v) * first * first + kernel.value_and_slope(v).slope * (Octet(2.0) * lane.kappa);
      total = total + keep(active, lane.amplitude * second);
    }
    add_curvature(kernel, run, run.cones, load_cone, t, total);
    add_curvature(kernel, run, run.circles, load_circle, t, total);
    return total;
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_curvature(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows, const Load& load_lanes,
                                double t, Octet& total) const {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      const LanePoint p = lanes.at(Octet(t), run.kernel->scale);
      const OctetMask active = p.v < kernel.support();
      const Octet v2 = lanes.second(Octet(t), run.kernel->scale);
      const Octet second = kernel.curvature(p.v) * p.slope * p.slope + kernel.value_and_slope(p.v).slope * v2;
      total = total + keep(active, lanes.amplitude * second);
    }
  }

  // ---- Bounds -------------------------------------------------------------------------------------------------------

  template <class Kernel>
  HWY_INLINE void add_remainder(const Kernel& kernel, const LaneRun& run, double t0, double t1,
                                RemainderSums& sums) const {
    const Octet h(t1 - t0);
    for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
      Octet from(t0), to(t1);
      OctetMask whole = from <= to;
      if (run.has_pieces) {
        const Octet begin = load_border(m_, i, LaneMemory::kBegin), end = load_border(m_, i, LaneMemory::kEnd);
        whole = (begin <= from) & (to <= end);
        from = max(from, begin);
        to = min(to, end);
      }
      sums.add_quadratics(kernel, load_quadratic(m_, i), from, to, whole, h);
    }
    add_lanes_remainder(kernel, run, run.cones, load_cone, t0, t1, sums);
    add_lanes_remainder(kernel, run, run.circles, load_circle, t0, t1, sums);
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_lanes_remainder(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows,
                                      const Load& load_lanes, double t0, double t1, RemainderSums& sums) const {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      sums.add_shapes(kernel, load_lanes(m_, i), Octet(t0), Octet(t1), run.kernel->scale, run.kernel->support);
    }
  }

  LaneMemory& m_;
  double threshold_ = 0;
  LaneSums sums_;
  double relative_noise_ = 0, threshold_noise_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
