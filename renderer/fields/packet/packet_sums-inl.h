// The sums that are found when the fields of a cell are laid out for eight rays (packet_setup-inl.h): bounds of the
// whole field, and the stretches on which it only rises or only falls.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_SUMS_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_SUMS_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_SUMS_INL_H_
#endif

#include "renderer/fields/ray/gather-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct PacketSums : SetupSums<Octet, Octet> {
  /// Along each ray no field falls before `rising_until`, and none rises behind `falling_from`: a field of positive
  /// strength rises until the ray has passed its skeleton. They are −∞ and ∞ where a field tells nothing of this. (If a
  /// point was passed a rounding later than computed, the sum has risen before by the square of a rounding, which is
  /// nothing beside the noise.)
  Octet rising_until, falling_from;

  HWY_INLINE PacketSums()
      : rising_until(std::numeric_limits<double>::infinity()), falling_from(-std::numeric_limits<double>::infinity()) {}

  /// Takes over the sums of these rays.
  HWY_INLINE void adopt(const PacketSums& from, const OctetMask& rays) {
    field_count = select(rays, from.field_count, field_count);
    peak = select(rays, from.peak, peak);
    moved = select(rays, from.moved, moved);
    exponent = from.exponent;
    rising_until = select(rays, from.rising_until, rising_until);
    falling_from = select(rays, from.falling_from, falling_from);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
