// The nearest hits that eight rays have met so far, side by side.
#if defined(ISL_RENDERER_TRACE_OCTET_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_OCTET_HITS_INL_H_
#undef ISL_RENDERER_TRACE_OCTET_HITS_INL_H_
#else
#define ISL_RENDERER_TRACE_OCTET_HITS_INL_H_
#endif

#include "renderer/csg/spread.h"
#include "renderer/rays/ray.h"
#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Crossings of one instance, a ray a lane.
struct OctetCrossings {
  Octet t;
  Octet part, leaf, cell;  ///< those of Hit
  OctetMask from_inside;
  OctetMask is_there;
  OctetMask alone;  ///< rays whose crossing is for single rays to find

  HWY_INLINE OctetCrossings() : leaf(scene::kNone), cell(scene::kNone), from_inside(no_lane()) {}
};

class OctetHits {
 public:
  /// No ray has met anything up to t_max.
  HWY_INLINE void start(const Octet& t_max) {
    store(t_max, t_);
    store(t_max, limits_);
    store(Octet(scene::kNone), instance_);
  }

  /// t_max where nothing is met yet.
  [[nodiscard]] HWY_INLINE Octet t() const { return load(t_); }
  [[nodiscard]] HWY_INLINE Octet instance() const { return load(instance_); }
  [[nodiscard]] HWY_INLINE OctetMask are_met() const { return instance() < Octet(scene::kNone); }
  /// The spread of the instances that are met (OctetStarts::nearness). Anything in other lanes.
  [[nodiscard]] HWY_INLINE Octet factor() const { return load(factor_); }
  [[nodiscard]] HWY_INLINE Octet size() const { return load(size_); }

  /// The farthest t at which hits of each ray must still be looked at.
  [[nodiscard]] const double* limits() const { return limits_; }

  /// Crossings of an instance become the nearest hits of these rays, with new limits.
  HWY_INLINE void take(const OctetMask& rays, std::uint32_t instance, const Spread& spread, const OctetCrossings& found,
                       const Octet& limits) {
    put(rays, found.t, t_);
    put(rays, limits, limits_);
    put(rays, Octet(instance), instance_);
    put(rays, found.part, part_);
    put(rays, found.leaf, leaf_);
    put(rays, found.cell, cell_);
    put(rays, Octet(spread.factor), factor_);
    put(rays, Octet(spread.size), size_);
    const std::uint32_t taken = bits(rays);
    from_inside_ = (from_inside_ & ~taken) | (bits(found.from_inside) & taken);
  }

  /// The hit of one ray; a miss has its t_max.
  [[nodiscard]] HWY_INLINE Hit operator[](std::size_t i) const {
    if (instance_[i] == scene::kNone) return {.t = t_[i]};
    return {t_[i],
            static_cast<InstanceId>(instance_[i]),
            static_cast<std::uint32_t>(cell_[i]),
            static_cast<std::uint32_t>(part_[i]),
            (from_inside_ >> i & 1) != 0,
            static_cast<std::uint32_t>(leaf_[i])};
  }

  HWY_INLINE void set(std::size_t i, const Hit& hit, const Spread& spread, double limit) {
    t_[i] = hit.t;
    limits_[i] = limit;
    instance_[i] = hit.instance;
    cell_[i] = hit.cell;
    part_[i] = hit.part;
    leaf_[i] = hit.leaf;
    factor_[i] = spread.factor;
    size_[i] = spread.size;
    from_inside_ = (from_inside_ & ~(1u << i)) | (hit.from_inside ? 1u << i : 0);
  }

 private:
  HWY_INLINE static void put(const OctetMask& rays, const Octet& value, double* values) {
    store(select(rays, value, load(values)), values);
  }

  // Numbers of instances, cells and leaves are exact as doubles.
  alignas(64) double t_[kOctet] = {};
  alignas(64) double limits_[kOctet] = {};
  alignas(64) double instance_[kOctet] = {};
  alignas(64) double cell_[kOctet] = {};
  alignas(64) double part_[kOctet] = {};
  alignas(64) double leaf_[kOctet] = {};
  alignas(64) double factor_[kOctet] = {};
  alignas(64) double size_[kOctet] = {};
  std::uint32_t from_inside_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
