// The crossings of eight lines with a surface of order 3 or 4, side by side.
#if defined(ISL_RENDERER_SOLIDS_OCTET_ROOTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_ROOTS_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_ROOTS_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_ROOTS_INL_H_
#endif

#include "renderer/solids/octet_bernstein-inl.h"
#include "renderer/solids/octet_intervals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct OctetRoots {
  static constexpr std::size_t kMost = OctetChanges::kMost;
  Octet t[kMost];           ///< ascending, beyond 0; infinite where there are no more
  OctetMask starts_inside;  ///< lines that are inside just beyond t = 0
  OctetMask alone;          ///< lines that are left to crossings()

  HWY_INLINE OctetRoots() : starts_inside(no_lane()), alone(no_lane()) {
    for (Octet& each : t) each = Octet(kInfinity);
  }
};

/// The parts of eight lines inside a surface of order 3 or 4.
struct OctetStretches {
  OctetIntervals first, second;
};

/// Lines that are inside on three stretches go to `alone`, too.
[[nodiscard]] HWY_INLINE OctetStretches stretches_of(const OctetRoots& roots, OctetMask& alone) {
  const OctetMask& inside = roots.starts_inside;
  alone = alone | roots.alone | (inside & (roots.t[3] < Octet(kInfinity)));
  const Octet side(kSide);
  return {{select(inside, Octet(-kInfinity), roots.t[0]), select(inside, roots.t[0], roots.t[1]), side, side},
          {select(inside, roots.t[1], roots.t[2]), select(inside, roots.t[2], roots.t[3]), side, side}};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
