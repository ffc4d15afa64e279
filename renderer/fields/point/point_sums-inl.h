// Sums of fields at a point: the value, the gradient, and each texture's share.
// ∇f = A φ′(v) ∇v, with v and ∇v from component_point.h.
#if defined(ISL_RENDERER_FIELDS_POINT_POINT_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_POINT_POINT_SUMS_INL_H_
#undef ISL_RENDERER_FIELDS_POINT_POINT_SUMS_INL_H_
#else
#define ISL_RENDERER_FIELDS_POINT_POINT_SUMS_INL_H_
#endif

#include "renderer/fields/component_point.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/point/blob_point.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// v and half its gradient for eight components, and their amplitudes.
struct KernelArguments {
  Octet v, gx, gy, gz, amplitude;
};

/// The arguments of one to eight components; v is beyond the support in the other lanes.
inline KernelArguments arguments_at(const ComponentTable& table, const FieldGroup& group,
                                    std::span<const std::uint32_t> items, const Vec3& point) {
  const double beyond = 2 * group.kernel.support;
  const auto count = static_cast<std::uint32_t>(items.size());
  std::uint32_t index[kOctet];
  for (std::uint32_t i = 0; i < kOctet; ++i) index[i] = items[std::min(i, count - 1)];
  KernelArguments at;
  at.amplitude = gather(table.amplitude.data(), index);
  if (group.skeleton == scene::Skeleton::point && !group.is_mapped) {
    // Points need no dispatch by skeleton, so eight are computed at once, with the operations of argument_at().
    const Octet scale = gather(table.scale.data(), index);
    const Octet x = Octet(point.x) - gather(table.x.data(), index), y = Octet(point.y) - gather(table.y.data(), index),
                z = Octet(point.z) - gather(table.z.data(), index);
    at.gx = x * scale;
    at.gy = y * scale;
    at.gz = z * scale;
    at.v = select(first_lanes(count), at.gx * x + at.gy * y + at.gz * z, Octet(beyond));
    return at;
  }
  at.v = Octet(beyond);
  at.gx = at.gy = at.gz = Octet(0.0);
  // The lanes are filled in registers. If they were written to memory one by one, loading the whole register would have
  // to wait until all writes are finished.
  for (std::uint32_t i = 0; i < count; ++i) {
    const KernelArgument own = argument_at(table, group, index[i], point);
    const OctetMask lane = mask_of(1U << i);
    at.v = select(lane, Octet(own.v), at.v);
    at.gx = select(lane, Octet(own.half_gradient.x), at.gx);
    at.gy = select(lane, Octet(own.half_gradient.y), at.gy);
    at.gz = select(lane, Octet(own.half_gradient.z), at.gz);
  }
  return at;
}

/// A sum of fields and its gradient.
struct PointSums {
  Octet value, magnitude, gx, gy, gz;
};

/// Collects the shares of a point.
class ShareSums {
 public:
  ShareSums(const ShareRule& rule, std::vector<TextureShare>& shares) : rule_(rule), shares_(shares) {}

  void clear() { shares_.clear(); }
  void add(const ComponentTable& table, std::uint32_t item, double weight) {
    const scene::TextureId texture = table.texture[item];
    const auto has_texture = [&](const TextureShare& s) { return s.texture == texture; };
    const auto share =
        rule_.may_share(texture) ? std::find_if(shares_.begin(), shares_.end(), has_texture) : shares_.end();
    if (share != shares_.end()) {
      share->weight += weight;
    } else {
      shares_.push_back({texture, weight});
      shares_.back().surface.component = table.source[item];
    }
  }

 private:
  const ShareRule& rule_;
  std::vector<TextureShare>& shares_;
};

/// Adds convolved curves, whose gradient is not a function of the nearest point.
inline void add_point_curves(const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                             std::uint32_t count, const Vec3& point, PointSums& sums, ShareSums& shares) {
  for (std::uint32_t i = 0; i < count; i += kOctet) {
    alignas(64) double value[kOctet] = {}, gx[kOctet] = {}, gy[kOctet] = {}, gz[kOctet] = {};
    for (std::uint32_t j = 0; j < std::min<std::uint32_t>(kOctet, count - i); ++j) {
      const std::uint32_t item = items[i + j];
      const CurveSample f = curve_at(table, group, item, point);
      if (f.value == 0) continue;
      value[j] = table.amplitude[item] * f.value;
      const Vec3 gradient = f.gradient * table.amplitude[item];
      gx[j] = gradient.x;
      gy[j] = gradient.y;
      gz[j] = gradient.z;
      shares.add(table, item, std::abs(value[j]));
    }
    sums.value = sums.value + load(value);
    sums.magnitude = sums.magnitude + abs(load(value));
    sums.gx = sums.gx + load(gx);
    sums.gy = sums.gy + load(gy);
    sums.gz = sums.gz + load(gz);
  }
}

template <class Kernel>
void add_point_group(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group,
                     const std::uint32_t* items, std::uint32_t count, const Vec3& point, PointSums& sums,
                     ShareSums& shares) {
  for (std::uint32_t i = 0; i < count; i += kOctet) {
    const std::uint32_t n = std::min<std::uint32_t>(kOctet, count - i);
    const KernelArguments at = arguments_at(table, group, {items + i, n}, point);
    const OctetMask active = at.v < kernel.support();
    const KernelValue phi = kernel.value_and_slope(at.v);
    const Octet value = keep(active, at.amplitude * phi.value);
    const Octet slope = keep(active, Octet(2.0) * at.amplitude * phi.slope);
    sums.value = sums.value + value;
    sums.magnitude = sums.magnitude + abs(value);
    sums.gx = sums.gx + slope * at.gx;
    sums.gy = sums.gy + slope * at.gy;
    sums.gz = sums.gz + slope * at.gz;
    alignas(64) double weights[kOctet];
    store(abs(value), weights);
    for (std::uint32_t j = 0; j < n; ++j) {
      if (weights[j] != 0) shares.add(table, items[i + j], weights[j]);
    }
  }
}

/// The sum of these components' fields at a point, with its gradient and texture shares. `items` ascend.
inline PointSums point_sums(const ComponentTable& table, std::span<const std::uint32_t> items, const Vec3& point,
                            ShareSums& shares) {
  PointSums sums{Octet(0.0), Octet(0.0), Octet(0.0), Octet(0.0), Octet(0.0)};
  shares.clear();
  const auto count = static_cast<std::uint32_t>(items.size());
  for (std::uint32_t next = 0; next < count;) {
    const FieldGroup& group = table.group_of(items[next]);
    std::uint32_t last = next;
    while (last < count && items[last] < group.end) ++last;
    if (group.kernel.is_convolved) {
      add_point_curves(table, group, items.data() + next, last - next, point, sums, shares);
    } else {
      with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
        add_point_group(kernel, table, group, items.data() + next, last - next, point, sums, shares);
      });
    }
    next = last;
  }
  return sums;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
