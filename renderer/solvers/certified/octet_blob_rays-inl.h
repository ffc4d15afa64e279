// Eight rays as a blob's solver sees them, side by side, and its answers (rays/blob_ray.h has those of one ray).
#if defined(ISL_RENDERER_SOLVERS_CERTIFIED_OCTET_BLOB_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CERTIFIED_OCTET_BLOB_RAYS_INL_H_
#undef ISL_RENDERER_SOLVERS_CERTIFIED_OCTET_BLOB_RAYS_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CERTIFIED_OCTET_BLOB_RAYS_INL_H_
#endif

#include "renderer/rays/blob_ray.h"
#include "renderer/solids/octet_vector-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Members as in BlobRay; bit i is that of ray i. Lanes without a ray may hold any numbers.
struct OctetBlobRays {
  OctetLines lines;
  Octet t_max, path_length;
  std::uint32_t start_on_surface = 0;
  std::uint32_t take_faint_dips = 0;
  bool any = false;  ///< the same for all rays

  [[nodiscard]] HWY_NOINLINE BlobRay operator[](std::size_t lane) const {
    const auto of = [lane](const Octet& x) HWY_ATTR {
      alignas(64) double lanes[kOctet];
      store(x, lanes);
      return lanes[lane];
    };
    const auto& [o, d] = lines;
    return {.origin = {of(o.x), of(o.y), of(o.z)},
            .direction = {of(d.x), of(d.y), of(d.z)},
            .t_max = of(t_max),
            .starts_on_surface = (start_on_surface >> lane & 1) != 0,
            .any = any,
            .path_length = of(path_length),
            .takes_faint_dips = (take_faint_dips >> lane & 1) != 0};
  }
};

/// Members as in BlobHit.
struct OctetBlobHits {
  std::uint32_t found = 0;          ///< bits of the rays that hit the blob; the others miss it
  std::uint32_t from_inside = 0;    ///< also of rays that miss
  std::uint32_t undecided = 0;      ///< bits of the rays that have an undecided_from
  alignas(64) double t[kOctet];     ///< of those in `found`, as is `cell`; if any hit will do, no hit lies before it
  alignas(64) double cell[kOctet];  // numbers of cells are exact as doubles
  alignas(64) double undecided_from[kOctet];

  [[nodiscard]] BlobHit operator[](std::size_t lane) const {
    BlobHit hit;
    if ((found >> lane & 1) != 0) {
      hit.t = t[lane];
      hit.cell = static_cast<std::uint32_t>(cell[lane]);
    }
    hit.from_inside = (from_inside >> lane & 1) != 0;
    if ((undecided >> lane & 1) != 0) hit.undecided_from = undecided_from[lane];
    return hit;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
