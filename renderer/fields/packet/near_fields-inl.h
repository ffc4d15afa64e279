// Tells which plain points of a list are near a packet's rays, four at a time, before any is laid out. In a large grid
// lists have ten fields and more, because small cells would cost more than they save, and rays meet the supports of two
// or three of them.
//
// The stretches of the rays lie in one capsule: around the segment halfway between those of the first and the last ray,
// as wide as any ray is off it at either end. A support that does not meet the capsule meets no stretch. The test is
// made in single floats with a margin for their rounding, so it may keep a field that is far, but drops none that
// is near.
#if defined(ISL_RENDERER_FIELDS_PACKET_NEAR_FIELDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_NEAR_FIELDS_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_NEAR_FIELDS_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_NEAR_FIELDS_INL_H_
#endif

#include "renderer/fields/packet/ray_packet.h"
#include "renderer/fields/support_balls.h"
#include "renderer/simd/quartet-inl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The lists that are worth a test. In shorter ones the capsule costs more than it saves. Longer ones are where many
/// fields overlap, and most of them are near.
inline constexpr std::size_t kLeastTested = 10, kMostTested = 32;

/// A capsule in the unit of SupportBalls.
struct Capsule {
  float start[3], along[3];
  float radius;
};

/// The capsule around the stretches of the rays in these lanes, of which there is at least one.
[[nodiscard]] HWY_INLINE Capsule capsule_around(const SupportBalls& supports, const RayPacket& rays,
                                                const OctetMask& lanes) {
  const std::uint32_t in_use = bits(lanes);
  const auto first = static_cast<std::size_t>(std::countr_zero(in_use));
  const auto last = static_cast<std::size_t>(std::bit_width(in_use) - 1);
  double from[3], to[3];
  Capsule capsule;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto halfway = [&](const double(&t)[kPacket]) HWY_ATTR {
      const auto at = [&](std::size_t ray) HWY_ATTR { return rays.origin[i][ray] + rays.direction[i][ray] * t[ray]; };
      return 0.5 * (at(first) + at(last));
    };
    from[i] = halfway(rays.t0);
    to[i] = halfway(rays.t1);
    capsule.start[i] = static_cast<float>((from[i] - supports.middle[static_cast<int>(i)]) * supports.per_unit);
    capsule.along[i] = static_cast<float>((to[i] - from[i]) * supports.per_unit);
  }
  double off = 0;
  if (first != last) {
    const Octet t0 = load(rays.t0), t1 = load(rays.t1);
    Octet at_start(0.0), at_end(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Octet origin = load(rays.origin[i]), direction = load(rays.direction[i]);
      const Octet a = origin + direction * t0 - Octet(from[i]), b = origin + direction * t1 - Octet(to[i]);
      at_start = at_start + a * a;
      at_end = at_end + b * b;
    }
    off = std::sqrt(greatest(keep(lanes, max(at_start, at_end))));
  }
  // No coordinate of the supports or of the segment is above `extent`. Distances are at most four times that, and each
  // of some sixteen numbers and operations is off by at most 2⁻²⁴ of the distance.
  float extent = 1;
  for (std::size_t i = 0; i < 3; ++i)
    extent = std::max(extent, std::abs(capsule.start[i]) + std::abs(capsule.along[i]));
  capsule.radius = static_cast<float>(off * supports.per_unit) + 0x1p-18F * extent;
  return capsule;
}

/// Copies those of `items` whose supports may meet the capsule to `near`, which has room for all, in their order.
/// Returns their number.
[[nodiscard]] inline HWY_NOINLINE std::size_t near_fields(const SupportBalls& supports, const RayPacket& rays,
                                                          const OctetMask& lanes, std::span<const std::uint32_t> items,
                                                          std::uint32_t* near) {
  const Capsule capsule = capsule_around(supports, rays, lanes);
  const auto square = [](const Quartet& x, const Quartet& y, const Quartet& z)
                          HWY_ATTR { return x * x + y * y + z * z; };
  const Quartet start_x(capsule.start[0]), start_y(capsule.start[1]), start_z(capsule.start[2]);
  const Quartet along_x(capsule.along[0]), along_y(capsule.along[1]), along_z(capsule.along[2]);
  const Quartet per_square = Quartet(1) / square(along_x, along_y, along_z);
  std::size_t count = 0;
  for (std::size_t first = 0; first < items.size(); first += kQuartet) {
    const std::size_t present = std::min(kQuartet, items.size() - first);
    std::array<std::uint32_t, kQuartet> item;
    std::array<const float*, kQuartet> ball;
    for (std::size_t i = 0; i < kQuartet; ++i) {
      item[i] = items[first + std::min(i, present - 1)];
      ball[i] = &supports.balls[item[i]].x;
    }
    const auto [centre_x, centre_y, centre_z, radius] = columns_of(ball);
    const Quartet x = centre_x - start_x, y = centre_y - start_y, z = centre_z - start_z;
    // The place on the segment nearest to the centre. On a segment without length it may be no number, and then nothing
    // is found to be far.
    const Quartet dot = x * along_x + y * along_y + z * along_z;
    const Quartet u = max(Quartet(0), min(Quartet(1), dot * per_square));
    const Quartet distance2 = square(x - u * along_x, y - u * along_y, z - u * along_z);
    const Quartet reach = radius + Quartet(capsule.radius);
    const std::uint32_t far = bits_above(distance2, reach * reach);
    for (std::size_t i = 0; i < present; ++i) {
      near[count] = item[i];
      count += (far >> i & 1) ^ 1;
    }
  }
  return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
