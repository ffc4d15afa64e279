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

#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

// A ray begins with eight numbers, which are read two by two.
static_assert(std::is_standard_layout_v<Ray> && offsetof(Ray, origin) == 0);
static_assert(offsetof(Ray, direction) == 3 * sizeof(double) && offsetof(Ray, t_max) == 6 * sizeof(double));
static_assert(offsetof(Ray, path_length) == 7 * sizeof(double));

/// Numbers `first` and first + 1 of eight rays. They are put together in registers: lanes that are written one by one
/// and read as a whole would have to wait for the cache.
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void load_numbers(const double* const (&rays)[kOctet], std::size_t first, Octet& one, Octet& next) {
  for (std::size_t i = 0; i < kOctet; ++i) {
    one.v[i] = hn::Load(Lanes(), rays[i] + first);
    next.v[i] = hn::Load(Lanes(), rays[i] + first + 1);
  }
}
#else
HWY_INLINE void load_numbers(const double* const (&rays)[kOctet], std::size_t first, Octet& one, Octet& next) {
  constexpr Two two;
  hn::Vec<Two> ones[kOctet / 2], nexts[kOctet / 2];
  for (std::size_t i = 0; i < kOctet / 2; ++i) {
    const auto a = hn::LoadU(two, rays[2 * i] + first), b = hn::LoadU(two, rays[2 * i + 1] + first);
    ones[i] = hn::InterleaveLower(two, a, b);
    nexts[i] = hn::InterleaveUpper(two, a, b);
  }
  one = joined(ones);
  next = joined(nexts);
}
#endif

/// Lanes without a ray repeat the first one.
struct OctetRays {
  OctetLines lines;
  Octet t_max, path_length;

  HWY_INLINE OctetRays() = default;
  /// Precondition: one to eight rays.
  HWY_INLINE explicit OctetRays(std::span<const Ray> rays) {
    const double* numbers[kOctet];
    for (std::size_t i = 0; i < kOctet; ++i) numbers[i] = &rays[i < rays.size() ? i : 0].origin.x;
    load_numbers(numbers, 0, lines.origin.x, lines.origin.y);
    load_numbers(numbers, 2, lines.origin.z, lines.direction.x);
    load_numbers(numbers, 4, lines.direction.y, lines.direction.z);
    load_numbers(numbers, 6, t_max, path_length);
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
  HWY_INLINE OctetStarts(std::span<const Ray> rays, const OctetRays& octets, const RayFaces& faces) {
    constexpr double kNowhere = -1;
    const OctetVector& origin = octets.lines.origin;
    reach = max(max(abs(origin.x), abs(origin.y)), abs(origin.z));
    instance = part = leaf = Octet(kNowhere);
    is_known = no_lane();
    const RayStart& first = rays.front().start;
    bool are_alike = true;
    for (const Ray& ray : rays) are_alike &= ray.start == first;
    if (are_alike) {
      if (first.instance == scene::kNone) return;
      const Spread& spread = faces.spread_of(first.instance);
      reach = reach + octets.path_length;
      reach = reach + (Octet(spread.factor) * reach + Octet(spread.size));
      instance = Octet(first.instance);
      part = Octet(first.part);
      leaf = Octet(first.leaf);
      is_known = all_lanes();
      return;
    }
    alignas(64) double values[5][kOctet];
    for (std::size_t i = 0; i < kOctet; ++i) {
      const bool is_known_here = i < rays.size() && rays[i].start.instance != scene::kNone;
      const RayStart start = is_known_here ? rays[i].start : RayStart{};
      const Spread spread = is_known_here ? faces.spread_of(start.instance) : Spread{0, 0};
      values[0][i] = spread.factor;
      values[1][i] = spread.size;
      values[2][i] = is_known_here ? start.instance : kNowhere;
      values[3][i] = is_known_here ? start.part : kNowhere;
      values[4][i] = is_known_here ? start.leaf : kNowhere;
    }
    instance = load(values[2]);
    part = load(values[3]);
    leaf = load(values[4]);
    is_known = instance >= Octet(0.0);
    reach = reach + keep(is_known, octets.path_length);
    reach = reach + (load(values[0]) * reach + load(values[1]));
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
