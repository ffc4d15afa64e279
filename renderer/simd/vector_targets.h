// A table of the vector widths for which Highway's foreach_target has compiled a file, to choose from at run time. Such
// a file includes this one once, in its HWY_ONCE part.
#pragma once

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdint>
#include <span>
#include <string>

namespace isl::render {

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
  const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
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
