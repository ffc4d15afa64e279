// The fields of a cell's list, laid out side by side for one stretch of a ray; what cannot reach the stretch is
// dropped.
//
// An affine component is met by a transformed ray whose direction is not normalised again, so that t means the same and
// no bound needs scaling. Squared distances come from perpendicular vectors, never from |oc|² − (oc·D)², which cancels
// far from the origin. Most cells that a ray meets hold no surface on its way, so this is where most of the time goes:
// the greatest value that the sum can have comes out of the same pass.
#if defined(ISL_RENDERER_FIELDS_LANE_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_LANE_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_LANE_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_LANE_SETUP_INL_H_
#endif

#include "renderer/fields/component_table.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/lane_columns-inl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What is known of a stretch once its fields are laid out.
struct LaneSums {
  std::uint32_t field_count = 0;
  double peak = 0;      ///< no value of the sum on the stretch is greater, rounding apart
  double exponent = 0;  ///< the greatest v within any support
};

class LaneSetup {
 public:
  explicit LaneSetup(LaneMemory& memory) : m_(memory) {}

  /// `items` ascend, and the seven entries behind them can be read and name components too (Grid::kListTail).
  [[nodiscard]] HWY_INLINE LaneSums gather_list(const ComponentTable& table, const std::uint32_t* items,
                                                std::uint32_t count, const Vec3& origin, const Vec3& direction,
                                                double t0, double t1) {
    m_.runs.clear();
    m_.reserve_lanes(count);
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
      with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
        add_group(kernel, table, group, items + next, last - next, origin, direction, t0, t1);
      });
      close_run(group, first_quadratic, first_cone);
      next = last;
    }
    return sums_;
  }

 private:
  template <class Kernel>
  HWY_INLINE void add_group(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group,
                            const std::uint32_t* items, std::uint32_t count, const Vec3& origin, const Vec3& direction,
                            double t0, double t1) {
    sums_.exponent = std::max(sums_.exponent, group.kernel.support);
    const std::uint32_t first_quadratic = quadratics_, first_cone = cones_;
    switch (group.form) {
      case FieldForm::point: return add_points(kernel, table, items, count, origin, direction, t0, t1);
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
    sums_.field_count += count;
    pad(first_quadratic, first_cone, group.kernel.support);
    sum_up(kernel, group, first_quadratic, first_cone, t0, t1);
  }

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ComponentTable& table, const std::uint32_t* items,
                             std::uint32_t count, const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const Octet ox(origin.x), oy(origin.y), oz(origin.z), dx(direction.x), dy(direction.y), dz(direction.z);
    const double dd = direction.length2();
    const Octet inverse_dd(1 / dd), from(t0), to(t1), zero(0.0);
    Octet peaks(0.0);
    for (std::uint32_t i = 0; i < count; i += kOctet) {
      const std::uint32_t* const index = items + i;
      const OctetMask listed = first_lanes(std::min<std::uint32_t>(kOctet, count - i));
      const Octet cx = gather(table.x.data(), index) - ox;
      const Octet cy = gather(table.y.data(), index) - oy;
      const Octet cz = gather(table.z.data(), index) - oz;
      const Octet scale = gather(table.scale.data(), index);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const Octet v0 = scale * (px * px + py * py + pz * pz);
      const Octet kappa = scale * Octet(dd);
      const Octet near = max(from, min(to, middle)) - middle;
      const Octet v_least = v0 + kappa * near * near;
      const OctetMask reaches = (v_least < kernel.support()) & listed;
      if (none(reaches)) continue;
      const Octet amplitude = gather(table.amplitude.data(), index);
      peaks = peaks + keep(reaches, max(amplitude, zero) * kernel.value(v_least));
      // Lanes that do not reach the stretch stay where they are: they are beyond their support all along it. (Moving
      // the others together costs more than it saves: lists are short.) Those past the list's end are put out of reach.
      double* const at = m_.quadratic.row(quadratics_);
      const std::size_t stride = m_.quadratic.stride();
      store(select(listed, v0, kernel.support() + kernel.support()), at + LaneMemory::kV0 * stride);
      store(keep(listed, kappa), at + LaneMemory::kKappa * stride);
      store(middle, at + LaneMemory::kMiddle * stride);
      store(amplitude, at + LaneMemory::kAmplitude * stride);
      quadratics_ += kOctet;
      sums_.field_count += static_cast<std::uint32_t>(std::popcount(bits(reaches)));
    }
    sums_.peak += sum(peaks);
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
    add_quadratic(scale * (oc - direction * middle).length2(), scale * dd, middle, amplitude, support, t0, t1, begin,
                  end);
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
      for (const int column : {LaneMemory::kKappa, LaneMemory::kMiddle, LaneMemory::kAmplitude})
        at[column * stride] = 0;
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

  /// Adds the greatest value that each lane can have on the stretch (add_points does so itself).
  template <class Kernel>
  void sum_up(const Kernel& kernel, const FieldGroup& group, std::uint32_t first_quadratic, std::uint32_t first_cone,
              double t0, double t1) {
    const Octet zero(0.0);
    Octet peaks(0.0);
    const auto add = [&](const OctetMask& reaches, const Octet& amplitude, const Octet& v_least)
                         HWY_ATTR { peaks = peaks + keep(reaches, max(amplitude, zero) * kernel.value(v_least)); };
    for (std::uint32_t i = first_quadratic; i < quadratics_; i += kOctet) {
      const QuadraticLanes lane = load_quadratic(m_, i);
      const Octet from = max(Octet(t0), load_border(m_, i, LaneMemory::kBegin));
      const Octet to = min(Octet(t1), load_border(m_, i, LaneMemory::kEnd));
      const Octet near = max(zero, max(from - lane.middle, lane.middle - to));
      const Octet v_least = lane.v0 + lane.kappa * near * near;
      add(v_least < kernel.support(), lane.amplitude, v_least);
    }
    for (std::uint32_t i = first_cone; i < cones_; i += kOctet) {
      const ConeLanes cone = load_cone(m_, i);
      const Octet v_least = cone.bounds(t0, t1, group.kernel.scale, group.kernel.support).least;
      add(v_least < kernel.support(), cone.amplitude, v_least);
    }
    sums_.peak += sum(peaks);
  }

  void close_run(const FieldGroup& group, std::uint32_t first_quadratic, std::uint32_t first_cone) {
    if (quadratics_ == first_quadratic && cones_ == first_cone) return;
    m_.runs.push_back(
        {&group.kernel, group.form != FieldForm::point, first_quadratic, quadratics_, first_cone, cones_});
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  LaneMemory& m_;
  LaneSums sums_;
  std::uint32_t quadratics_ = 0, cones_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
