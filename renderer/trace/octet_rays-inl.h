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

#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Lanes without a ray hold zeros.
struct OctetRays {
  OctetLines lines;
  Octet reach;                                   ///< RayFaces::reach_before
  Octet start_instance, start_part, start_leaf;  ///< of RayStart; scene::kNone is a number like others
  OctetMask has_start;

  HWY_INLINE OctetRays() = default;
  HWY_INLINE OctetRays(std::span<const Ray> rays, const RayFaces& faces) {
    alignas(64) double values[10][kOctet] = {};
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray& ray = rays[i];
      for (int axis = 0; axis < 3; ++axis) {
        values[axis][i] = ray.origin[axis];
        values[3 + axis][i] = ray.direction[axis];
      }
      values[6][i] = faces.reach_before(ray);
      values[7][i] = ray.start.instance;
      values[8][i] = ray.start.part;
      values[9][i] = ray.start.leaf;
    }
    lines = {{load(values[0]), load(values[1]), load(values[2])}, {load(values[3]), load(values[4]), load(values[5])}};
    reach = load(values[6]);
    start_instance = load(values[7]);
    start_part = load(values[8]);
    start_leaf = load(values[9]);
    has_start = start_instance < Octet(scene::kNone);
  }

  /// As RayFaces::nearness() of a shape with this spread.
  [[nodiscard]] HWY_INLINE Octet nearness(const Spread& spread, const Octet& t) const {
    return Octet(kNear) * (Octet(spread.factor) * (reach + abs(t)) + Octet(spread.size));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
