// Sums of fields at eight points at once, one point in every lane: the value, the gradient, and the sum of magnitudes.
// Points whose fields are those of one list read each of them once. A point has the same sums whatever the other lanes
// hold.
#if defined(ISL_RENDERER_FIELDS_POINT_OCTET_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_POINT_OCTET_SUMS_INL_H_
#undef ISL_RENDERER_FIELDS_POINT_OCTET_SUMS_INL_H_
#else
#define ISL_RENDERER_FIELDS_POINT_OCTET_SUMS_INL_H_
#endif

#include "renderer/fields/component_point.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/point/blob_point.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class OctetSums {
 public:
  /// Begins the sums of one to eight points. Lanes without a point repeat the first one. The queries must outlive this.
  explicit OctetSums(std::span<const FieldQuery> queries) : queries_(queries) {
    static_assert(sizeof(FieldQuery) % sizeof(double) == 0);
    constexpr std::uint32_t kStride = sizeof(FieldQuery) / sizeof(double);
    std::uint32_t index[kOctet];
    for (std::uint32_t i = 0; i < kOctet; ++i) index[i] = i < queries.size() ? kStride * i : 0;
    const double* const first = &queries.front().point.x;
    x_ = gather(first, index);
    y_ = gather(first + 1, index);
    z_ = gather(first + 2, index);
  }

  /// Adds these components to the points whose bits in `lanes` are set. `items` ascend.
  void add(const ComponentTable& table, std::span<const std::uint32_t> items, std::uint32_t lanes) {
    for (std::size_t next = 0; next < items.size();) {
      const FieldGroup& group = table.group_of(items[next]);
      std::size_t last = next + 1;
      while (last < items.size() && items[last] < group.end) ++last;
      const std::span<const std::uint32_t> own = items.subspan(next, last - next);
      if (group.kernel.is_convolved) {
        for (const std::uint32_t item : own) add_curve(table, group, item, lanes);
      } else {
        with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
          if (group.skeleton == scene::Skeleton::point && !group.is_mapped) {
            add_points(kernel, table, own, mask_of(lanes));
          } else {
            for (const std::uint32_t item : own) add_shape(kernel, table, group, item, lanes);
          }
        });
      }
      next = last;
    }
  }

  /// Writes the sums of each point.
  void store_to(std::span<BlobFields> results) const {
    alignas(64) double numbers[5][kOctet];
    store(sums_.value, numbers[0]);
    store(sums_.magnitude, numbers[1]);
    store(sums_.gx, numbers[2]);
    store(sums_.gy, numbers[3]);
    store(sums_.gz, numbers[4]);
    for (std::size_t i = 0; i < results.size(); ++i)
      results[i] = {numbers[0][i], numbers[1][i], {numbers[2][i], numbers[3][i], numbers[4][i]}};
  }

 private:
  struct Sums {
    Octet value, magnitude, gx, gy, gz;

    HWY_INLINE Sums() : value(0.0), magnitude(0.0), gx(0.0), gy(0.0), gz(0.0) {}
    /// Adds a field at v, half of whose gradient is (hx, hy, hz).
    template <class Kernel>
    HWY_INLINE void add(const Kernel& kernel, double amplitude, const Octet& v, const Octet& hx, const Octet& hy,
                        const Octet& hz, const OctetMask& lanes) {
      const OctetMask active = (v < kernel.support()) & lanes;
      const KernelValue phi = kernel.value_and_slope(v);
      const Octet f = keep(active, Octet(amplitude) * phi.value);
      const Octet slope = keep(active, Octet(2 * amplitude) * phi.slope);
      value = value + f;
      magnitude = magnitude + abs(f);
      gx = gx + slope * hx;
      gy = gy + slope * hy;
      gz = gz + slope * hz;
    }
  };

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ComponentTable& table, std::span<const std::uint32_t> items,
                             const OctetMask& lanes) {
    const Octet x = x_, y = y_, z = z_;
    Sums sums = sums_;  // a member would be written and read back for every component
    for (const std::uint32_t item : items) {
      const Octet scale(table.scale[item]);
      const Octet dx = x - Octet(table.x[item]), dy = y - Octet(table.y[item]), dz = z - Octet(table.z[item]);
      const Octet hx = dx * scale, hy = dy * scale, hz = dz * scale;
      sums.add(kernel, table.amplitude[item], hx * dx + hy * dy + hz * dz, hx, hy, hz, lanes);
    }
    sums_ = sums;
  }

  template <class Kernel>
  void add_shape(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group, std::uint32_t item,
                 std::uint32_t lanes) {
    Octet v(0.0), hx(0.0), hy(0.0), hz(0.0);
    for_each_lane(lanes, [&](std::size_t i, const OctetMask& lane) HWY_ATTR {
      const KernelArgument own = argument_at(table, group, item, queries_[i].point);
      v = select(lane, Octet(own.v), v);
      hx = select(lane, Octet(own.half_gradient.x), hx);
      hy = select(lane, Octet(own.half_gradient.y), hy);
      hz = select(lane, Octet(own.half_gradient.z), hz);
    });
    sums_.add(kernel, table.amplitude[item], v, hx, hy, hz, mask_of(lanes));
  }

  /// The gradient of a convolved curve is not a function of the nearest point.
  void add_curve(const ComponentTable& table, const FieldGroup& group, std::uint32_t item, std::uint32_t lanes) {
    const double amplitude = table.amplitude[item];
    for_each_lane(lanes, [&](std::size_t i, const OctetMask& lane) HWY_ATTR {
      const CurveSample f = curve_at(table, group, item, queries_[i].point);
      const auto add = [&](Octet& sum, double x) HWY_ATTR { sum = sum + keep(lane, Octet(amplitude * x)); };
      add(sums_.value, f.value);
      add(sums_.magnitude, amplitude < 0 ? -f.value : f.value);
      add(sums_.gx, f.gradient.x);
      add(sums_.gy, f.gradient.y);
      add(sums_.gz, f.gradient.z);
    });
  }

  template <class Use>
  static HWY_INLINE void for_each_lane(std::uint32_t lanes, const Use& use) {
    for (; lanes != 0; lanes &= lanes - 1)
      use(static_cast<std::size_t>(std::countr_zero(lanes)), mask_of(lanes & ~(lanes - 1)));
  }

  std::span<const FieldQuery> queries_;
  Octet x_, y_, z_;
  Sums sums_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
