// Eight rays in a component's own space.
#if defined(ISL_RENDERER_FIELDS_PACKET_PLACED_LINES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PLACED_LINES_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PLACED_LINES_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PLACED_LINES_INL_H_
#endif

#include "renderer/fields/packet/ray_packet.h"
#include "renderer/fields/ray/gather-inl.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// As PlacedLine, for eight rays.
class PlacedLines : public Lines<Octet> {
 public:
  Octet start;  ///< t where each ray is nearest to the component's middle; o is there
  Octet size;   ///< as in PlacedLine

  HWY_INLINE PlacedLines(const RayPacket& rays, const ListedFields& fields, std::uint32_t item) {
    const ComponentTable& table = fields.table;
    Octet origin[3], direction[3];
    for (std::size_t i = 0; i < 3; ++i) {
      origin[i] = load(rays.origin[i]);
      direction[i] = load(rays.direction[i]);
    }
    const Octet centre[3] = {Octet(table.x[item]), Octet(table.y[item]), Octet(table.z[item])};
    const scene::Transform* const map =
        fields.group.is_mapped ? &table.blob_from_component(fields.group, item) : nullptr;
    for (int i = 0; i < 3; ++i) {
      o[i] = map ? image(origin, map->inverse, i) + Octet(map->inverse[3][i]) : origin[i];
      d[i] = map ? image(direction, map->inverse, i) : direction[i];
    }
    Octet along(0.0);
    length2_ = Octet(0.0);
    for (int i = 0; i < 3; ++i) {
      along = along + (centre[i] - o[i]) * d[i];
      length2_ = length2_ + d[i] * d[i];
    }
    const Octet t = along / length2_;
    const bool has_middle = !scene::is_endless(fields.group.skeleton);
    start = has_middle ? keep(abs(t) < Octet(std::numeric_limits<double>::infinity()), t) : Octet(0.0);
    for (std::size_t i = 0; i < 3; ++i) origin[i] = origin[i] + direction[i] * start;
    Octet terms(0.0);
    distance2_ = Octet(0.0);
    for (int i = 0; i < 3; ++i) {
      o[i] = map ? image(origin, map->inverse, i) + Octet(map->inverse[3][i]) : origin[i];
      const Octet away = o[i] - centre[i];
      distance2_ = distance2_ + away * away;
      if (!map) continue;
      Octet sum(std::abs(map->inverse[3][i]));
      for (int j = 0; j < 3; ++j) sum = sum + abs(origin[j] * Octet(map->inverse[j][i]));
      terms = max(terms, sum);
    }
    size = sqrt(distance2_) + terms;
  }

  /// The lanes whose stretch from t0 to t1 meets the ball around the component's middle that holds its support,
  /// wherever positions are off by their rounding errors. No others can reach the component.
  template <class Shape>
  [[nodiscard]] HWY_INLINE OctetMask near_ball(const Shape& shape, double support_root, const Octet& t0,
                                               const Octet& t1) const {
    const Octet near = max(t0, min(t1, start)) - start;
    const Octet radius(shape.extent() + shape.thickest() * support_root);
    const Octet farthest = radius + Octet(kPositionError) * (size + radius);
    // A distance that is no number knows nothing.
    return and_not(distance2_ + length2_ * near * near > farthest * farthest, all_lanes());
  }

 private:
  /// Coordinate i of the image of a vector.
  [[nodiscard]] static HWY_INLINE Octet image(const Octet (&v)[3], const scene::Matrix& m, int i) {
    return v[0] * Octet(m[0][i]) + v[1] * Octet(m[1][i]) + v[2] * Octet(m[2][i]);
  }

  Octet distance2_;  ///< |o − middle|²
  Octet length2_;    ///< |d|²
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
