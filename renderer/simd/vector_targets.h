// A table of the vector widths for which Highway's foreach_target has compiled a file, to choose from at run time. Such
// a file includes this one once, in its HWY_ONCE part.
#pragma once

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdint>
#include <span>
#include <string>

namespace isl::render {

/// The widths that this machine has. Highway's own function is in a library whose loading takes 3 ms, half of what a
/// program takes that prints its version. (Whoever has AVX2 has F16C, for which clang's built-in has no name.)
[[nodiscard]] inline std::int64_t supported_targets() {
  std::int64_t targets = HWY_STATIC_TARGET;
#if HWY_ARCH_X86_64
  __builtin_cpu_init();
  const bool has_sse4 = __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") &&
                        __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool has_avx2 = has_sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool has_avx3 = has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  if (has_sse4) targets |= HWY_SSE4;
  if (has_avx2) targets |= HWY_AVX2;
  if (has_avx3) targets |= HWY_AVX3;
#endif
  return targets;
}

/// One vector width; `make` returns its entry points.
template <class EntryPoints>
struct VectorTarget {
  std::int64_t bit;
  const EntryPoints* (*make)();
};

/// The entry points for the widest vectors that this machine has, or for the target named ("AVX3", "AVX2", "SSE4", …).
/// Null if the machine or the program lacks it. `targets` come widest first.
template <class EntryPoints>
[[nodiscard]] const EntryPoints* entry_points_of(std::span<const VectorTarget<EntryPoints>> targets,
                                                 const std::string& name) {
  const std::int64_t supported = supported_targets();
  for (const VectorTarget<EntryPoints>& target : targets) {
    if ((supported & target.bit) == 0) continue;
    if (name.empty() || name == hwy::TargetName(target.bit)) return target.make();
  }
  return nullptr;
}

}  // namespace isl::render

#if HWY_TARGETS & HWY_AVX3
#define ISL_TARGET_AVX3(make) {HWY_AVX3, &N_AVX3::make},
#else
#define ISL_TARGET_AVX3(make)
#endif
#if HWY_TARGETS & HWY_AVX2
#define ISL_TARGET_AVX2(make) {HWY_AVX2, &N_AVX2::make},
#else
#define ISL_TARGET_AVX2(make)
#endif
#if HWY_TARGETS & HWY_SSE4
#define ISL_TARGET_SSE4(make) {HWY_SSE4, &N_SSE4::make},
#else
#define ISL_TARGET_SSE4(make)
#endif
/// Rows of VectorTarget, widest first; the last is the static target, which every machine has.
#define ISL_VECTOR_TARGETS(make) \
  ISL_TARGET_AVX3(make) ISL_TARGET_AVX2(make) ISL_TARGET_SSE4(make) { HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(make) }
