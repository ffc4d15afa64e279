// The fields of one cell along one ray, side by side in octets: set up once for a stretch of the ray, then asked for value,
// slope, curvature and bounds at any t or interval in it. What cannot reach the stretch is dropped at set-up.
//
// Two forms cover all skeletons. Quadratic lanes: v = v₀ + κ(t − t₀)² on [begin, end), for points and for the three pieces of a
// segment (end spheres, and between the end planes the distance to the axis). Cone lanes: the round cone of skeletons/limb.h in
// (x, ρ²), x = x₀ + x′t and ρ² = n₀ + n₂(t − tₙ)². An affine component is met by a transformed ray whose direction is not
// normalised again, so that t means the same and no bound needs scaling. Squared distances come from perpendicular vectors,
// never from |oc|² − (oc·D)², which cancels far from the origin.
#if defined(ISL_RENDERER_FIELDS_RAY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANES_INL_H_
#endif

#include "renderer/fields/component_table.h"
#include "renderer/fields/kernels/gaussian-inl.h"
#include "renderer/fields/kernels/quartic-inl.h"
#include "renderer/fields/lane_memory.h"
#include "renderer/fields/skeletons/cone_lanes-inl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// F − T and its derivative along the ray.
struct FieldAt {
  double value, slope;
  double magnitude, steepness;  ///< Σ|fᵢ| and Σ|fᵢ′|: what rounding is relative to
};

/// How far a cubic Hermite interpolant of F may be from F over an interval of width h: |F − p| ≤ value, |F′ − p′| ≤ slope.
struct Remainder {
  double value, slope;
};

class RayLanes {
 public:
  explicit RayLanes(LaneMemory& memory) : m_(memory) {}

  /// Gathers the fields of a cell's list that reach t in [t0, t1]. `items` ascend.
  void set_up(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const Vec3& origin,
              const Vec3& direction, double t0, double t1) {
    m_.runs.clear();
    m_.reserve_lanes(count);
    threshold_ = table.threshold;
    quadratics_ = cones_ = 0;
    peak_sum_ = exponent_ = 0;
    field_count_ = 0;
    std::uint32_t next = 0;
    while (next < count) {
      const FieldGroup& group = table.group_of(items[next]);
      std::uint32_t last = next + 1;
      if (items[count - 1] < group.end) {
        last = count;
      } else {
        while (last < count && items[last] < group.end) ++last;
      }
      const std::uint32_t first_quadratic = quadratics_, first_cone = cones_;
      switch (group.kernel.shape) {
        case scene::KernelShape::quartic:
          add_group(Quartic(group.kernel), table, group, items + next, last - next, origin, direction, t0, t1);
          break;
        case scene::KernelShape::gaussian:
          add_group(Gaussian(group.kernel), table, group, items + next, last - next, origin, direction, t0, t1);
          break;
      }
      close_run(group, first_quadratic, first_cone);
      next = last;
    }
    relative_noise_ = 0x1p-52 * (field_count_ + 16.0 + 2 * exponent_);
    threshold_noise_ = 0x1p-52 * (field_count_ + 16.0) * std::abs(threshold_);
  }

  [[nodiscard]] bool is_empty() const { return m_.runs.empty(); }
  [[nodiscard]] std::uint32_t field_count() const { return field_count_; }
  /// No value of F − T on the stretch is greater than this.
  [[nodiscard]] double upper_bound() const { return peak_sum_ * (1 + relative_noise_) - threshold_ + threshold_noise_; }
  /// Bounds of the rounding in the value and the slope at t. That of a sum of n fields is 2⁻⁵² Σ|fᵢ|(n + 16 + 2v) + 2⁻⁵²(n + 16)T,
  /// the exponential magnifying the error of its argument v; that of the position is four half units of t.
  [[nodiscard]] double noise(double t, const FieldAt& f) const {
    return relative_noise_ * f.magnitude + threshold_noise_ + 0x1p-51 * std::abs(t) * f.steepness;
  }
  [[nodiscard]] double slope_noise(const FieldAt& f) const { return relative_noise_ * f.steepness; }

  [[nodiscard]] FieldAt at(double t) const {
    FieldSums sums{Octet(0.0), Octet(0.0), Octet(0.0), Octet(0.0)};
    for (const LaneRun& run : m_.runs) {
      with_kernel(run, [&](const auto& kernel) HWY_ATTR { add_at(kernel, run, t, sums); });
    }
    return {sum(sums.value) - threshold_, sum(sums.slope), sum(sums.magnitude), sum(sums.steepness)};
  }

  /// F″ at t (one-sided where a border of a support or of a piece falls on t).
  [[nodiscard]] double curvature(double t) const {
    Octet total(0.0);
    for (const LaneRun& run : m_.runs) {
      with_kernel(run, [&](const auto& kernel) HWY_ATTR { total = total + curvature_of(kernel, run, t); });
    }
    return sum(total);
  }

  [[nodiscard]] Remainder remainder(double t0, double t1) const {
    Octet value(0.0), slope(0.0);
    for (const LaneRun& run : m_.runs) {
      with_kernel(run, [&](const auto& kernel) HWY_ATTR { add_remainder(kernel, run, t0, t1, value, slope); });
    }
    return {sum(value), sum(slope)};
  }

 private:
  template <class Use>
  static HWY_INLINE void with_kernel(const LaneRun& run, Use&& use) {
    switch (run.kernel->shape) {
      case scene::KernelShape::quartic: use(Quartic(*run.kernel)); break;
      case scene::KernelShape::gaussian: use(Gaussian(*run.kernel)); break;
    }
  }

  // ---- Set-up -------------------------------------------------------------------------------------------------------

  template <class Kernel>
  void add_group(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                 std::uint32_t count, const Vec3& origin, const Vec3& direction, double t0, double t1) {
    exponent_ = std::max(exponent_, group.kernel.support);
    const std::uint32_t first_quadratic = quadratics_, first_cone = cones_;
    switch (group.form) {
      case FieldForm::point: add_points(table, items, count, kernel.support(), origin, direction, t0, t1); break;
      case FieldForm::limb:
        for (std::uint32_t i = 0; i < count; ++i) {
          add_limb(table, items[i], group.kernel, origin, direction, t0, t1);
        }
        break;
      case FieldForm::affine_point:
      case FieldForm::affine_limb:
        for (std::uint32_t i = 0; i < count; ++i) {
          const scene::Transform& map = table.blob_from_component[items[i] - table.first_affine];
          const Vec3 o = map.inverse_point(origin), d = map.inverse_vector(direction);
          if (group.form == FieldForm::affine_limb) {
            add_limb(table, items[i], group.kernel, o, d, t0, t1);
          } else {
            const Vec3 centre(table.x[items[i]], table.y[items[i]], table.z[items[i]]);
            add_sphere(centre, table.scale[items[i]], table.amplitude[items[i]], group.kernel.support, o, d, t0, t1,
                       -kInfinity, kInfinity);
          }
        }
        break;
    }
    if (group.form != FieldForm::point) field_count_ += count;
    pad(first_quadratic, first_cone, group.kernel.support);
    sum_up(kernel, group, first_quadratic, first_cone, t0, t1);
  }

  void add_points(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const Octet& support,
                  const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const Octet ox(origin.x), oy(origin.y), oz(origin.z), dx(direction.x), dy(direction.y), dz(direction.z);
    const double dd = direction.length2();
    const Octet inverse_dd(1 / dd), from(t0), to(t1);
    for (std::uint32_t i = 0; i < count; i += kOctet) {
      alignas(64) std::uint32_t index[kOctet];
      const std::uint32_t valid = std::min<std::uint32_t>(kOctet, count - i);
      for (std::uint32_t j = 0; j < kOctet; ++j) index[j] = items[i + std::min(j, valid - 1)];
      const Octet cx = gather(table.x.data(), index) - ox;
      const Octet cy = gather(table.y.data(), index) - oy;
      const Octet cz = gather(table.z.data(), index) - oz;
      const Octet scale = gather(table.scale.data(), index);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const Octet v0 = scale * (px * px + py * py + pz * pz);
      const Octet kappa = scale * Octet(dd);
      const Octet near = max(from, min(to, middle)) - middle;
      const OctetMask reaches = (v0 + kappa * near * near < support) & first_lanes(valid);
      if (none(reaches)) continue;
      // Lanes that do not reach the stretch stay where they are: they are beyond their support all along it. (Moving the others
      // together costs more than it saves: lists are short.) Those past the list's end are put out of reach.
      double* const at = m_.quadratic.row(quadratics_);
      const std::size_t stride = m_.quadratic.stride();
      const OctetMask listed = first_lanes(valid);
      store(select(listed, v0, support + support), at + LaneMemory::kV0 * stride);
      store(keep(listed, kappa), at + LaneMemory::kKappa * stride);
      store(middle, at + LaneMemory::kMiddle * stride);
      store(gather(table.amplitude.data(), index), at + LaneMemory::kAmplitude * stride);
      quadratics_ += kOctet;
      field_count_ += static_cast<std::uint32_t>(std::popcount(bits(reaches)));
    }
  }

  static HWY_INLINE OctetMask first_lanes(std::uint32_t n) {
    alignas(64) static constexpr double kIndex[kOctet] = {0, 1, 2, 3, 4, 5, 6, 7};
    return load(kIndex) < Octet(static_cast<double>(n));
  }

  /// The lane of a sphere, valid on [begin, end).
  void add_sphere(const Vec3& centre, double scale, double amplitude, double support, const Vec3& origin,
                  const Vec3& direction, double t0, double t1, double begin, double end) {
    const Vec3 oc = centre - origin;
    const double dd = direction.length2();
    const double middle = oc.dot(direction) / dd;
    add_quadratic(scale * (oc - direction * middle).length2(), scale * dd, middle, amplitude, support, t0, t1, begin, end);
  }

  void add_quadratic(double v0, double kappa, double middle, double amplitude, double support, double t0, double t1,
                     double begin, double end) {
    const double from = std::max(t0, begin), to = std::min(t1, end);
    if (!(from <= to)) return;
    const double near = std::clamp(middle, from, to) - middle;
    if (!(v0 + kappa * near * near < support)) return;
    double* const at = m_.quadratic.row(quadratics_++);
    const std::size_t stride = m_.quadratic.stride();
    at[LaneMemory::kV0 * stride] = v0;
    at[LaneMemory::kKappa * stride] = kappa;
    at[LaneMemory::kMiddle * stride] = middle;
    at[LaneMemory::kAmplitude * stride] = amplitude;
    at[LaneMemory::kBegin * stride] = begin;
    at[LaneMemory::kEnd * stride] = end;
  }

  /// A segment becomes up to three quadratic lanes, a cone one cone lane.
  void add_limb(const ComponentTable& table, std::uint32_t item, const KernelConstants& kernel, const Vec3& origin,
                const Vec3& direction, double t0, double t1) {
    const Limb& limb = table.limbs[item - table.first_limb];
    const double amplitude = table.amplitude[item];
    const Vec3 oa = origin - limb.a;
    const double x0 = oa.dot(limb.axis), dx = direction.dot(limb.axis);
    const Vec3 o = oa - limb.axis * x0, d = direction - limb.axis * dx;
    const double n2 = d.length2();
    const double middle = n2 > 0 ? -o.dot(d) / n2 : 0.0;
    const double n0 = (o + d * middle).length2();
    if (limb.slope != 0) {
      double* const at = m_.cone.row(cones_++);
      const std::size_t stride = m_.cone.stride();
      at[LaneMemory::kX0 * stride] = x0;
      at[LaneMemory::kDx * stride] = dx;
      at[LaneMemory::kN0 * stride] = n0;
      at[LaneMemory::kN2 * stride] = n2;
      at[LaneMemory::kNMiddle * stride] = middle;
      at[LaneMemory::kRadius * stride] = limb.radius;
      at[LaneMemory::kSlope * stride] = limb.slope;
      at[LaneMemory::kLength * stride] = limb.length;
      at[LaneMemory::kConeAmplitude * stride] = amplitude;
      return;
    }
    const double scale = table.scale[item] / (limb.radius * limb.radius);
    const double support = kernel.support;
    const Vec3 b = limb.a + limb.axis * limb.length;
    const double at_a = -x0 / dx, at_b = (limb.length - x0) / dx;  // where the ray crosses the end planes
    const auto sphere = [&](const Vec3& centre, double begin, double end) {
      add_sphere(centre, scale, amplitude, support, origin, direction, t0, t1, begin, end);
    };
    const auto body = [&](double begin, double end) {
      add_quadratic(scale * n0, scale * n2, middle, amplitude, support, t0, t1, begin, end);
    };
    if (!std::isfinite(at_a) || !std::isfinite(at_b)) {  // parallel to the end planes: one piece for the whole ray
      if (x0 < 0) return sphere(limb.a, -kInfinity, kInfinity);
      if (x0 > limb.length) return sphere(b, -kInfinity, kInfinity);
      return body(-kInfinity, kInfinity);
    }
    const bool forward = dx > 0;
    sphere(forward ? limb.a : b, -kInfinity, std::min(at_a, at_b));
    body(std::min(at_a, at_b), std::max(at_a, at_b));
    sphere(forward ? b : limb.a, std::max(at_a, at_b), kInfinity);
  }

  /// Fills the last octet of each form with lanes that add nothing.
  void pad(std::uint32_t first_quadratic, std::uint32_t first_cone, double support) {
    while ((quadratics_ - first_quadratic) % kOctet != 0) {
      double* const at = m_.quadratic.row(quadratics_++);
      const std::size_t stride = m_.quadratic.stride();
      at[LaneMemory::kV0 * stride] = 2 * support;
      for (const int column : {LaneMemory::kKappa, LaneMemory::kMiddle, LaneMemory::kAmplitude}) at[column * stride] = 0;
      at[LaneMemory::kBegin * stride] = -kInfinity;
      at[LaneMemory::kEnd * stride] = kInfinity;
    }
    while ((cones_ - first_cone) % kOctet != 0) {
      double* const at = m_.cone.row(cones_++);
      for (int column = 0; column < LaneMemory::kConeColumns; ++column) at[column * m_.cone.stride()] = 0;
      at[LaneMemory::kN0 * m_.cone.stride()] = kInfinity;
      at[LaneMemory::kRadius * m_.cone.stride()] = 1;
    }
  }

  /// The greatest value that each lane can have on the stretch.
  template <class Kernel>
  void sum_up(const Kernel& kernel, const FieldGroup& group, std::uint32_t first_quadratic, std::uint32_t first_cone,
              double t0, double t1) {
    const Octet zero(0.0);
    Octet peaks(0.0);
    const auto add = [&](const OctetMask& reaches, const Octet& amplitude, const Octet& v_least) HWY_ATTR {
      peaks = peaks + keep(reaches, max(amplitude, zero) * kernel.value(v_least));
    };
    const bool has_pieces = group.form != FieldForm::point;
    for (std::uint32_t i = first_quadratic; i < quadratics_; i += kOctet) {
      const QuadraticLanes lane = quadratic(i);
      Octet from(t0), to(t1);
      if (has_pieces) {
        from = max(from, quadratic_column(i, LaneMemory::kBegin));
        to = min(to, quadratic_column(i, LaneMemory::kEnd));
      }
      const Octet near = max(zero, max(from - lane.middle, lane.middle - to));
      const Octet v_least = lane.v0 + lane.kappa * near * near;
      add(v_least < kernel.support(), lane.amplitude, v_least);
    }
    for (std::uint32_t i = first_cone; i < cones_; i += kOctet) {
      const ConeLanes cone = cone_lanes(i);
      const Octet v_least = cone.bounds(t0, t1, group.kernel.scale, group.kernel.support).least;
      add(v_least < kernel.support(), cone.amplitude, v_least);
    }
    peak_sum_ += sum(peaks);
  }

  void close_run(const FieldGroup& group, std::uint32_t first_quadratic, std::uint32_t first_cone) {
    if (quadratics_ == first_quadratic && cones_ == first_cone) return;
    m_.runs.push_back({&group.kernel, group.form != FieldForm::point, first_quadratic, quadratics_, first_cone, cones_});
  }

  // ---- Evaluation ---------------------------------------------------------------------------------------------------

  struct QuadraticLanes {
    Octet v0, kappa, middle, amplitude;
  };
  [[nodiscard]] HWY_INLINE QuadraticLanes quadratic(std::uint32_t i) const {
    const double* const at = m_.quadratic.row(i);
    const std::size_t stride = m_.quadratic.stride();
    return {load(at + LaneMemory::kV0 * stride), load(at + LaneMemory::kKappa * stride),
            load(at + LaneMemory::kMiddle * stride), load(at + LaneMemory::kAmplitude * stride)};
  }
  [[nodiscard]] HWY_INLINE ConeLanes cone_lanes(std::uint32_t i) const {
    const double* const at = m_.cone.row(i);
    const std::size_t stride = m_.cone.stride();
    return {load(at + LaneMemory::kX0 * stride),      load(at + LaneMemory::kDx * stride),
            load(at + LaneMemory::kN0 * stride),      load(at + LaneMemory::kN2 * stride),
            load(at + LaneMemory::kNMiddle * stride), load(at + LaneMemory::kRadius * stride),
            load(at + LaneMemory::kSlope * stride),   load(at + LaneMemory::kLength * stride),
            load(at + LaneMemory::kConeAmplitude * stride)};
  }
  [[nodiscard]] HWY_INLINE Octet quadratic_column(std::uint32_t i, int column) const {
    return load(m_.quadratic.row(i) + static_cast<std::size_t>(column) * m_.quadratic.stride());
  }
  [[nodiscard]] HWY_INLINE OctetMask on_piece(const LaneRun& run, std::uint32_t i, const Octet& t, const OctetMask& mask) const {
    if (!run.has_pieces) return mask;
    return mask & (t >= quadratic_column(i, LaneMemory::kBegin)) & (t < quadratic_column(i, LaneMemory::kEnd));
  }

  struct FieldSums {
    Octet value, slope, magnitude, steepness;

    HWY_INLINE void add(const Octet& f, const Octet& d) {
      value = value + f;
      slope = slope + d;
      magnitude = magnitude + abs(f);
      steepness = steepness + abs(d);
    }
  };

  template <class Kernel>
  HWY_INLINE void add_at(const Kernel& kernel, const LaneRun& run, double t, FieldSums& sums) const {
    for (std::uint32_t i = run.first_quadratic; i < run.last_quadratic; i += kOctet) {
      const QuadraticLanes lane = quadratic(i);
      const Octet tau = Octet(t) - lane.middle;
      const Octet kappa_tau = lane.kappa * tau;
      const Octet v = lane.v0 + kappa_tau * tau;
      const OctetMask active = on_piece(run, i, Octet(t), v < kernel.support());
      const KernelValue phi = kernel.value_and_slope(v);
      sums.add(keep(active, lane.amplitude * phi.value),
               keep(active, lane.amplitude * (phi.slope * (Octet(2.0) * kappa_tau))));
    }
    for (std::uint32_t i = run.first_cone; i < run.last_cone; i += kOctet) {
      const ConeLanes cone = cone_lanes(i);
      const ConePoint p = cone.at(Octet(t), run.kernel->scale);
      const OctetMask active = p.v < kernel.support();
      const KernelValue phi = kernel.value_and_slope(p.v);
      sums.add(keep(active, cone.amplitude * phi.value), keep(active, cone.amplitude * (phi.slope * p.slope)));
    }
  }

  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet curvature_of(const Kernel& kernel, const LaneRun& run, double t) const {
    Octet total(0.0);
    for (std::uint32_t i = run.first_quadratic; i < run.last_quadratic; i += kOctet) {
      const QuadraticLanes lane = quadratic(i);
      const Octet tau = Octet(t) - lane.middle;
      const Octet first = Octet(2.0) * lane.kappa * tau;
      const Octet v = lane.v0 + lane.kappa * tau * tau;
      const OctetMask active = on_piece(run, i, Octet(t), v < kernel.support());
      const Octet second = kernel.curvature(v) * first * first + kernel.value_and_slope(v).slope * (Octet(2.0) * lane.kappa);
      total = total + keep(active, lane.amplitude * second);
    }
    for (std::uint32_t i = run.first_cone; i < run.last_cone; i += kOctet) {
      const ConeLanes cone = cone_lanes(i);
      const ConePoint p = cone.at(Octet(t), run.kernel->scale);
      const OctetMask active = p.v < kernel.support();
      const Octet v2 = cone.second(Octet(t), run.kernel->scale);
      const Octet second = kernel.curvature(p.v) * p.slope * p.slope + kernel.value_and_slope(p.v).slope * v2;
      total = total + keep(active, cone.amplitude * second);
    }
    return total;
  }

  // ---- Bounds -------------------------------------------------------------------------------------------------------

  /// E and E′ of a cubic Hermite interpolant of width h. In the smooth case h⁴M₄/384 and (√3/216)h³M₄; where f is only C¹,
  /// (h²/32)·osc f″ and 0.126 h·osc f″, osc counting the 0 beyond a border. The lesser of both where both hold.
  static HWY_INLINE void add_bounds(const SecondAndFourth& bounds, const OctetMask& smooth, const OctetMask& counts,
                                    const Octet& amplitude, double h, Octet& value, Octet& slope) {
    const Octet zero(0.0), size = abs(amplitude);
    const Octet spread = select(smooth, bounds.high - bounds.low, max(bounds.high, zero) - min(bounds.low, zero));
    const Octet fourth = select(smooth, bounds.fourth, Octet(kInfinity));
    const Octet h2(h * h);
    const Octet e = min(h2 * Octet(1.0 / 32) * spread, h2 * h2 * Octet(1.0 / 384) * fourth);
    const Octet e1 = min(Octet(0.126 * h) * spread, Octet(0.00801876) * h2 * Octet(h) * fourth);  // √3/216
    value = value + keep(counts, size * e);
    slope = slope + keep(counts, size * e1);
  }

  template <class Kernel>
  HWY_INLINE void add_remainder(const Kernel& kernel, const LaneRun& run, double t0, double t1, Octet& value, Octet& slope) const {
    const double h = t1 - t0;
    for (std::uint32_t i = run.first_quadratic; i < run.last_quadratic; i += kOctet) {
      const QuadraticLanes lane = quadratic(i);
      Octet from(t0), to(t1);
      OctetMask whole = from <= to;
      if (run.has_pieces) {
        const Octet begin = quadratic_column(i, LaneMemory::kBegin), end = quadratic_column(i, LaneMemory::kEnd);
        whole = (begin <= from) & (to <= end);
        from = max(from, begin);
        to = min(to, end);
      }
      const Octet a = from - lane.middle, b = to - lane.middle;
      const Octet near = max(Octet(0.0), max(a, Octet(0.0) - b));
      const Octet far = max(abs(a), abs(b));
      const Octet room = kernel.support() - lane.v0;  // κτ² where the support ends
      const Octet u_near = lane.kappa * near * near, u_far = lane.kappa * far * far;
      const OctetMask smooth = whole & (u_far < room);
      const OctetMask counts = (u_near < room) & (from <= to);
      add_bounds(kernel.on_quadratic(lane.v0, lane.kappa, u_near, min(u_far, room)), smooth, counts, lane.amplitude, h, value,
                 slope);
    }
    for (std::uint32_t i = run.first_cone; i < run.last_cone; i += kOctet) {
      const ConeLanes cone = cone_lanes(i);
      const ConeBounds v = cone.bounds(t0, t1, run.kernel->scale, run.kernel->support);
      const OctetMask counts = v.least < kernel.support();
      const OctetMask smooth = v.one_piece & (v.greatest < kernel.support());
      add_bounds(v.compose(kernel), smooth, counts, cone.amplitude, h, value, slope);
    }
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  LaneMemory& m_;
  double threshold_ = 0;
  std::uint32_t quadratics_ = 0, cones_ = 0, field_count_ = 0;
  double peak_sum_ = 0, exponent_ = 0, relative_noise_ = 0, threshold_noise_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
