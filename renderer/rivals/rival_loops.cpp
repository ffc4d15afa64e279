// The rival solvers' inner loops, compiled and chosen as the product's are (trace_entry_points.cpp), which they leave
// as it is: the world, the grids and the cells' driver are the same code, and only what finds a root in a cell is a
// rival's.
#include "renderer/trace/rival_module.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/rivals/rival_loops.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "renderer/simd/fallback_target.h"

#include "base/check.h"
#include "renderer/solvers/baselines/climb-inl.h"
#include "renderer/solvers/baselines/inclusion-inl.h"
#include "renderer/solvers/baselines/interval-inl.h"
#include "renderer/solvers/baselines/lg-inl.h"
#include "renderer/solvers/baselines/march-inl.h"
#include "renderer/solvers/baselines/segment-inl.h"
#include "renderer/solvers/baselines/sphere-inl.h"
#include "renderer/solvers/cells/cell_search-inl.h"
#include "renderer/trace/single_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The solver that the settings name.
struct RivalSearch {
  template <class Solver>
  [[nodiscard]] static HWY_NOINLINE BlobHit search(const CompiledBlob& blob, const SolverSettings& settings,
                                                   TraceMemory& memory, TraceCounters& counters, const BlobRay& ray) {
    return CellSearch<Solver>(blob, settings, memory.lanes, counters).first_hit(ray);
  }

  [[nodiscard]] static BlobHit first_hit(const CompiledBlob& blob, const SolverSettings& settings, TraceMemory& memory,
                                         TraceCounters& counters, const BlobRay& ray) {
    switch (settings.name) {
#define ISL_SOLVER(word, family, argument)
#define ISL_RIVAL(word, Type, argument) \
  case SolverName::word:                \
    return search<Type>(blob, settings, memory, counters, ray);
#include "renderer/rays/solvers.def"
      default: break;
    }
    ISL_CHECK(false, "no rival: {}", static_cast<int>(settings.name));
  }
};

void rival_first_hits(const CompiledScene& scene, const SolverSettings& settings, RayKind kind,
                      std::span<const Ray> rays, std::span<Hit> hits, TraceMemory& memory, TraceCounters& counters) {
  SingleTrace<RivalSearch> world(scene, settings, kind, memory, counters);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = world.trace(rays[i], false);
}

void rival_occlusions(const CompiledScene& scene, const SolverSettings& settings, RayKind kind,
                      std::span<const Ray> rays, std::span<std::uint8_t> occluded, TraceMemory& memory,
                      TraceCounters& counters) {
  SingleTrace<RivalSearch> world(scene, settings, kind, memory, counters);
  for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = occlusion_of(world.trace(rays[i], true));
}

const TraceLoops* loops() {
  static const TraceLoops instance{rival_first_hits, rival_occlusions};
  return &instance;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "renderer/simd/vector_targets.h"
#include "renderer/trace/header_stamp.h"

const char* isl_rivals_stamp() { return isl::render::kHeaderStamp; }

const isl::render::TraceLoops* isl_rivals_loops(const char* target) {
  using namespace isl::render;
  static constexpr VectorTarget<TraceLoops> kTargets[] = {ISL_VECTOR_TARGETS(loops)};
  return entry_points_of<TraceLoops>(kTargets, target);
}
#endif
