// Four floats side by side, whatever the width of the machine's registers: for rough tests of many things, which are
// made again in doubles where they decide. As with Octet, every operation is the IEEE one in every lane.
#if defined(ISL_RENDERER_SIMD_QUARTET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SIMD_QUARTET_INL_H_
#undef ISL_RENDERER_SIMD_QUARTET_INL_H_
#else
#define ISL_RENDERER_SIMD_QUARTET_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

using FloatLanes = hn::CappedTag<float, 4>;
inline constexpr std::size_t kQuartet = 4;
inline constexpr std::size_t kFloatLanes = hn::MaxLanes(FloatLanes());
inline constexpr std::size_t kFloatRegisters = kQuartet / kFloatLanes;

struct Quartet {
  hn::Vec<FloatLanes> v[kFloatRegisters];

  HWY_INLINE Quartet() = default;
  HWY_INLINE Quartet(float x) {  // NOLINT: a number stands for four of it
    for (auto& r : v) r = hn::Set(FloatLanes(), x);
  }
};

#define ISL_QUARTET_BINARY(name, operation)                                                   \
  HWY_INLINE Quartet name(const Quartet& a, const Quartet& b) {                               \
    Quartet r;                                                                                \
    for (std::size_t i = 0; i < kFloatRegisters; ++i) r.v[i] = hn::operation(a.v[i], b.v[i]); \
    return r;                                                                                 \
  }
ISL_QUARTET_BINARY(operator+, Add)
ISL_QUARTET_BINARY(operator-, Sub)
ISL_QUARTET_BINARY(operator*, Mul)
ISL_QUARTET_BINARY(operator/, Div)
ISL_QUARTET_BINARY(min, Min)
ISL_QUARTET_BINARY(max, Max)
#undef ISL_QUARTET_BINARY

/// Bit i: a > b in lane i.
[[nodiscard]] HWY_INLINE std::uint32_t bits_above(const Quartet& a, const Quartet& b) {
  std::uint32_t r = 0;
  for (std::size_t i = 0; i < kFloatRegisters; ++i) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatLanes(), hn::Gt(a.v[i], b.v[i]), bytes);
    r |= std::uint32_t{bytes[0]} << (i * kFloatLanes);
  }
  return r;
}

/// Four rows of four floats, by columns. `Tag` is FloatLanes. Where registers have one lane there are no shuffles, so
/// they are named without their namespace: a target that does not use them need not have them.
template <class Tag = FloatLanes>
[[nodiscard]] HWY_INLINE std::array<Quartet, kQuartet> columns_of(const std::array<const float*, kQuartet>& rows) {
  const Tag tag;
  std::array<Quartet, kQuartet> columns;
  if constexpr (kFloatRegisters == 1) {
    const auto row = [&](std::size_t i) HWY_ATTR { return hn::LoadU(tag, rows[i]); };
    const auto low01 = InterleaveLower(tag, row(0), row(1)), low23 = InterleaveLower(tag, row(2), row(3));
    const auto high01 = InterleaveUpper(tag, row(0), row(1)), high23 = InterleaveUpper(tag, row(2), row(3));
    columns[0].v[0] = ConcatLowerLower(tag, low23, low01);
    columns[1].v[0] = ConcatUpperUpper(tag, low23, low01);
    columns[2].v[0] = ConcatLowerLower(tag, high23, high01);
    columns[3].v[0] = ConcatUpperUpper(tag, high23, high01);
  } else {
    for (std::size_t k = 0; k < kQuartet; ++k) {
      const float column[kQuartet] = {rows[0][k], rows[1][k], rows[2][k], rows[3][k]};
      for (std::size_t i = 0; i < kFloatRegisters; ++i) columns[k].v[i] = hn::LoadU(tag, column + i * kFloatLanes);
    }
  }
  return columns;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
