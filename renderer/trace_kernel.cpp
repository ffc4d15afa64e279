// The inner loops for every vector width. This file is compiled once for each target (Highway's foreach_target includes it
// again), with everything that ends in -inl.h inlined into it, and the widest that the machine has is chosen at run time.
#include "renderer/trace_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/trace_kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "renderer/fields/blob_point-inl.h"
#include "renderer/solvers/paper_point-inl.h"
#include "renderer/solvers/world_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

void first_hits(const CompiledScene& scene, const SolverSettings& settings, std::span<const Ray> rays, std::span<Hit> hits,
                TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(true);
  WorldTrace world(scene, settings, memory, counters);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = world.trace(rays[i], false);
}

void occlusions(const CompiledScene& scene, const SolverSettings& settings, std::span<const Ray> rays,
                std::span<std::uint8_t> occluded, TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(false);
  WorldTrace world(scene, settings, memory, counters);
  for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = world.trace(rays[i], true).is_miss() ? 0 : 1;
}

const TraceKernel* kernel() {
  static const TraceKernel instance{hwy::TargetName(HWY_TARGET), first_hits, occlusions, blob_point, paper_point};
  return &instance;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isl::render {
namespace {

struct Target {
  std::int64_t bit;
  const TraceKernel* (*kernel)();
};

/// Widest first; the last is the baseline, which every machine has.
constexpr Target kTargets[] = {
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, &N_AVX3::kernel},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, &N_AVX2::kernel},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, &N_SSE4::kernel},
#endif
    {HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(kernel)},
};

}  // namespace

const TraceKernel* trace_kernel(const std::string& name) {
  const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
  for (const Target& target : kTargets) {
    if ((supported & target.bit) == 0) continue;
    if (name.empty() || name == hwy::TargetName(target.bit)) return target.kernel();
  }
  return nullptr;
}

}  // namespace isl::render
#endif
