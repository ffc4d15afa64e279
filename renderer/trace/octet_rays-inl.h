// Eight rays side by side, with their starts, as solids and combinations of solids meet them.
#if defined(ISL_RENDERER_TRACE_OCTET_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_OCTET_RAYS_INL_H_
#undef ISL_RENDERER_TRACE_OCTET_RAYS_INL_H_
#else
#define ISL_RENDERER_TRACE_OCTET_RAYS_INL_H_
#endif

#include "renderer/rays/ray.h"
#include "renderer/solids/octet_vector-inl.h"
#include "renderer/trace/ray_faces.h"

#include <limits>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Lanes without a ray hold zeros.
struct OctetRays {
  OctetLines lines;
  Octet t_max, path_length;
  Octet start;  ///< RayStart::instance, scene::kNone included

  HWY_INLINE OctetRays() = default;
  HWY_INLINE explicit OctetRays(std::span<const Ray> rays) {
    alignas(64) double values[9][kOctet];
    for (std::size_t i = rays.size(); i < kOctet; ++i) {
      for (auto& lanes : values) lanes[i] = 0;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray& ray = rays[i];
      for (int axis = 0; axis < 3; ++axis) {
        values[axis][i] = ray.origin[axis];
        values[3 + axis][i] = ray.direction[axis];
      }
      values[6][i] = ray.t_max;
      values[7][i] = ray.path_length;
      values[8][i] = ray.start.instance;
    }
    lines = {{load(values[0]), load(values[1]), load(values[2])}, {load(values[3]), load(values[4]), load(values[5])}};
    t_max = load(values[6]);
    path_length = load(values[7]);
    start = load(values[8]);
  }

  /// Rays whose numbers are finite and whose direction is not zero.
  [[nodiscard]] HWY_INLINE OctetMask are_sound() const {
    const auto& [o, d] = lines;
    const Octet sum = o.x + o.y + o.z + d.x + d.y + d.z;
    return (abs(sum) < Octet(std::numeric_limits<double>::infinity())) & (d.dot(d) > Octet(0.0));
  }
};

/// The surfaces that eight rays start on, and how far rounding may have moved the starts.
struct OctetStarts {
  Octet reach;                 ///< RayFaces::reach_before
  Octet instance, part, leaf;  ///< of RayStart; below 0 in lanes whose ray starts on no surface
  OctetMask is_known;

  HWY_INLINE OctetStarts() = default;
  HWY_INLINE OctetStarts(std::span<const Ray> rays, const OctetVector& origin, const RayFaces& faces) {
    constexpr double kNowhere = -1;
    reach = max(max(abs(origin.x), abs(origin.y)), abs(origin.z));
    instance = part = leaf = Octet(kNowhere);
    is_known = no_lane();
    bool is_any_known = false;
    for (const Ray& ray : rays) is_any_known |= ray.start.instance != scene::kNone;
    if (!is_any_known) return;
    alignas(64) double values[6][kOctet];
    for (std::size_t i = 0; i < kOctet; ++i) {
      const bool is_known_here = i < rays.size() && rays[i].start.instance != scene::kNone;
      const RayStart start = is_known_here ? rays[i].start : RayStart{};
      const Spread spread = is_known_here ? faces.spread_of(start.instance) : Spread{0, 0};
      values[0][i] = is_known_here ? rays[i].path_length : 0;
      values[1][i] = spread.factor;
      values[2][i] = spread.size;
      values[3][i] = is_known_here ? start.instance : kNowhere;
      values[4][i] = is_known_here ? start.part : kNowhere;
      values[5][i] = is_known_here ? start.leaf : kNowhere;
    }
    reach = reach + load(values[0]);
    reach = reach + (load(values[1]) * reach + load(values[2]));
    instance = load(values[3]);
    part = load(values[4]);
    leaf = load(values[5]);
    is_known = instance >= Octet(0.0);
  }

  /// As RayFaces::nearness() of a shape with this spread.
  [[nodiscard]] HWY_INLINE Octet nearness(const Octet& factor, const Octet& size, const Octet& t) const {
    return Octet(kNear) * (factor * (reach + abs(t)) + size);
  }
  [[nodiscard]] HWY_INLINE Octet nearness(const Spread& spread, const Octet& t) const {
    return nearness(Octet(spread.factor), Octet(spread.size), t);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
