// Eight doubles side by side, whatever the width of the machine's registers: the unit in which fields are evaluated.
// A target with 2 lanes holds four registers, one with 8 lanes a single one; every operation is the IEEE one in every
// lane and sums run through one fixed tree, so that all targets give the same bits. There are no fused multiply-adds.
#if defined(ISL_RENDERER_SIMD_OCTET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SIMD_OCTET_INL_H_
#undef ISL_RENDERER_SIMD_OCTET_INL_H_
#else
#define ISL_RENDERER_SIMD_OCTET_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, 8>;
using Register = hn::Vec<Lanes>;
using RegisterMask = hn::Mask<Lanes>;
inline constexpr std::size_t kOctet = 8;
inline constexpr std::size_t kLanes = hn::MaxLanes(Lanes());
inline constexpr std::size_t kRegisters = kOctet / kLanes;

struct OctetMask {
  RegisterMask m[kRegisters];
};

struct Octet {
  Register v[kRegisters];

  HWY_INLINE Octet() = default;
  HWY_INLINE Octet(double x) {  // NOLINT: a number stands for eight of it
    for (auto& r : v) r = hn::Set(Lanes(), x);
  }
};

#define ISL_OCTET_BINARY(name, operation)                                                \
  HWY_INLINE Octet name(const Octet& a, const Octet& b) {                                \
    Octet r;                                                                             \
    for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = hn::operation(a.v[i], b.v[i]); \
    return r;                                                                            \
  }
#define ISL_OCTET_COMPARE(name, operation)                                               \
  HWY_INLINE OctetMask name(const Octet& a, const Octet& b) {                            \
    OctetMask r;                                                                         \
    for (std::size_t i = 0; i < kRegisters; ++i) r.m[i] = hn::operation(a.v[i], b.v[i]); \
    return r;                                                                            \
  }
#define ISL_OCTET_UNARY(name, operation)                                         \
  HWY_INLINE Octet name(const Octet& a) {                                        \
    Octet r;                                                                     \
    for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = hn::operation(a.v[i]); \
    return r;                                                                    \
  }
#define ISL_OCTET_LOGICAL(name, operation)                                               \
  HWY_INLINE OctetMask name(const OctetMask& a, const OctetMask& b) {                    \
    OctetMask r;                                                                         \
    for (std::size_t i = 0; i < kRegisters; ++i) r.m[i] = hn::operation(a.m[i], b.m[i]); \
    return r;                                                                            \
  }
ISL_OCTET_BINARY(operator+, Add)
ISL_OCTET_BINARY(operator-, Sub)
ISL_OCTET_BINARY(operator*, Mul)
ISL_OCTET_BINARY(operator/, Div)
ISL_OCTET_BINARY(min, Min)
ISL_OCTET_BINARY(max, Max)
ISL_OCTET_BINARY(copysign, CopySign)
ISL_OCTET_COMPARE(operator<, Lt)
ISL_OCTET_COMPARE(operator<=, Le)
ISL_OCTET_COMPARE(operator!=, Ne)
ISL_OCTET_COMPARE(operator>, Gt)
ISL_OCTET_COMPARE(operator>=, Ge)
ISL_OCTET_COMPARE(equal, Eq)
ISL_OCTET_UNARY(sqrt, Sqrt)
ISL_OCTET_UNARY(abs, Abs)
ISL_OCTET_LOGICAL(operator&, And)
ISL_OCTET_LOGICAL(operator|, Or)
#undef ISL_OCTET_BINARY
#undef ISL_OCTET_COMPARE
#undef ISL_OCTET_UNARY
#undef ISL_OCTET_LOGICAL

HWY_INLINE Octet select(const OctetMask& m, const Octet& yes, const Octet& no) {
  Octet r;
  for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = hn::IfThenElse(m.m[i], yes.v[i], no.v[i]);
  return r;
}
/// Lanes of `m` that are not in `out`.
HWY_INLINE OctetMask and_not(const OctetMask& out, const OctetMask& m) {
  OctetMask r;
  for (std::size_t i = 0; i < kRegisters; ++i) r.m[i] = hn::AndNot(out.m[i], m.m[i]);
  return r;
}
/// x where m holds, else 0.
HWY_INLINE Octet keep(const OctetMask& m, const Octet& x) {
  Octet r;
  for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = hn::IfThenElseZero(m.m[i], x.v[i]);
  return r;
}
HWY_INLINE bool none(const OctetMask& m) {
  bool r = true;
  for (std::size_t i = 0; i < kRegisters; ++i) r = r && hn::AllFalse(Lanes(), m.m[i]);
  return r;
}
// These do the same for one number, so that one formula serves both.
HWY_INLINE double select(bool condition, double yes, double no) { return condition ? yes : no; }
HWY_INLINE double sqrt(double x) { return std::sqrt(x); }
HWY_INLINE double abs(double x) { return std::abs(x); }

/// Bit i is lane i.
HWY_INLINE std::uint32_t bits(const OctetMask& m) {
  std::uint32_t r = 0;
  for (std::size_t i = 0; i < kRegisters; ++i) {
    std::uint8_t b[8] = {};
    hn::StoreMaskBits(Lanes(), m.m[i], b);
    r |= std::uint32_t{b[0]} << (i * kLanes);
  }
  return r;
}

[[nodiscard]] HWY_INLINE OctetMask no_lane() { return Octet(0.0) < Octet(0.0); }
[[nodiscard]] HWY_INLINE OctetMask all_lanes() { return Octet(0.0) <= Octet(0.0); }
/// Lane i is bit i.
[[nodiscard]] HWY_INLINE OctetMask mask_of(std::uint32_t bits) {
  OctetMask r;
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const std::uint8_t b[8] = {static_cast<std::uint8_t>(bits >> (i * kLanes) & ((1u << kLanes) - 1))};
    r.m[i] = hn::LoadMaskBits(Lanes(), b);
  }
  return r;
}

/// Loads 8 consecutive doubles, 64-byte aligned.
HWY_INLINE Octet load(const double* p) {
  Octet r;
  for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = hn::Load(Lanes(), p + i * kLanes);
  return r;
}
/// Lanes 0 to n − 1.
[[nodiscard]] HWY_INLINE OctetMask first_lanes(std::uint32_t n) {
  alignas(64) static constexpr double kIndex[kOctet] = {0, 1, 2, 3, 4, 5, 6, 7};
  return load(kIndex) < Octet(static_cast<double>(n));
}
HWY_INLINE void store(const Octet& x, double* p) {
  for (std::size_t i = 0; i < kRegisters; ++i) hn::Store(x.v[i], Lanes(), p + i * kLanes);
}
#if HWY_TARGET != HWY_SCALAR
using Two = hn::FixedTag<double, 2>;
/// A register of numbers that are there two by two.
template <class D>
HWY_INLINE hn::Vec<D> joined_register(D lanes, const hn::Vec<Two>* pairs) {
  if constexpr (hn::MaxLanes(D()) == 2) {
    return pairs[0];
  } else if constexpr (hn::MaxLanes(D()) == 4) {
    return hn::Combine(lanes, pairs[1], pairs[0]);
  } else {
    const hn::Half<D> half;
    return hn::Combine(lanes, hn::Combine(half, pairs[3], pairs[2]), hn::Combine(half, pairs[1], pairs[0]));
  }
}
/// Eight numbers that are there two by two.
HWY_INLINE Octet joined(const hn::Vec<Two> (&pairs)[kOctet / 2]) {
  Octet r;
  for (std::size_t i = 0; i < kRegisters; ++i) r.v[i] = joined_register(Lanes(), pairs + i * (kLanes / 2));
  return r;
}
#endif

/// base[index[i]] for eight indices. The instruction that does it takes longer than loads two by two.
HWY_INLINE Octet gather(const double* base, const std::uint32_t* index) {
#if HWY_TARGET == HWY_SCALAR
  Octet r;
  for (std::size_t i = 0; i < kOctet; ++i) r.v[i] = hn::Set(Lanes(), base[index[i]]);
  return r;
#else
  constexpr Two two;
  hn::Vec<Two> pairs[kOctet / 2];
  for (std::size_t i = 0; i < kOctet / 2; ++i)
    pairs[i] = hn::InterleaveLower(two, hn::Set(two, base[index[2 * i]]), hn::Set(two, base[index[2 * i + 1]]));
  return joined(pairs);
#endif
}

#if HWY_TARGET == HWY_SCALAR  // a single lane has no halves
HWY_INLINE double sum_lanes(Lanes, Register x) { return hn::GetLane(x); }
#else
template <class D>
HWY_INLINE double sum_lanes(D d, hn::Vec<D> x) {
  if constexpr (hn::MaxLanes(d) == 1) {
    return hn::GetLane(x);
  } else {
    const hn::Half<D> half;
    return sum_lanes(half, hn::Add(hn::LowerHalf(half, x), hn::UpperHalf(half, x)));
  }
}
#endif

/// The least and the greatest of eight numbers.
HWY_INLINE double least(const Octet& x) {
  Register r = x.v[0];
  for (std::size_t i = 1; i < kRegisters; ++i) r = hn::Min(r, x.v[i]);
  return hn::GetLane(hn::MinOfLanes(Lanes(), r));
}
HWY_INLINE double greatest(const Octet& x) {
  Register r = x.v[0];
  for (std::size_t i = 1; i < kRegisters; ++i) r = hn::Max(r, x.v[i]);
  return hn::GetLane(hn::MaxOfLanes(Lanes(), r));
}

/// ((x0+x4)+(x2+x6)) + ((x1+x5)+(x3+x7)) on every target: halves are added to halves until one number is left.
HWY_INLINE double sum(Octet x) {
  for (std::size_t n = kRegisters / 2; n > 0; n /= 2) {
    for (std::size_t i = 0; i < n; ++i) x.v[i] = hn::Add(x.v[i], x.v[i + n]);
  }
  return sum_lanes(Lanes(), x.v[0]);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
