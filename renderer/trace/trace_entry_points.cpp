// The inner loops for every vector width. This file is compiled once for each target (Highway's foreach_target includes
// it again), with everything that ends in -inl.h inlined into it. The widest target that the machine has is chosen at
// run time.
#include "renderer/trace/trace_entry_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/trace/trace_entry_points.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "renderer/simd/fallback_target.h"

#include "renderer/compiled/blob_point-inl.h"
#include "renderer/solvers/cells/cell_search-inl.h"
#include "renderer/solvers/certified/hermite-inl.h"
#include "renderer/solvers/certified/packet_search-inl.h"
#include "renderer/solvers/published/paper-inl.h"
#include "renderer/solvers/published/paper_point-inl.h"
#include "renderer/trace/world_trace-inl.h"

#include <algorithm>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The product's solver, or the published one.
struct ProductSearch {
  [[nodiscard]] static BlobHit first_hit(const CompiledBlob& blob, const SolverSettings& settings, TraceMemory& memory,
                                         TraceCounters& counters, const BlobRay& ray) {
    if (is_published(settings.name)) return PaperSearch(blob, settings, memory.paper, counters).first_hit(ray);
    return CellSearch<HermiteSolver>(blob, settings, memory.lanes, counters).first_hit(ray);
  }

  [[nodiscard]] static bool takes_packets(const CompiledBlob& blob) { return PacketSearch::takes(blob); }
  static void first_hits(const CompiledBlob& blob, const SolverSettings& settings, TraceMemory& memory,
                         TraceCounters& counters, const BlobRay* rays, std::uint32_t rays_in_use, BlobHit* hits) {
    PacketSearch(blob, settings, memory.lanes, memory.packet, memory.rays, counters)
        .first_hits(rays, rays_in_use, hits);
  }
};

/// Calls use(hit of ray i, i) for all rays, in packets where that pays. `any`: any hit will do.
template <class Use>
HWY_INLINE void trace_all(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, bool any,
                          std::span<const Ray> rays, TraceMemory& memory, TraceCounters& counters, const Use& use) {
  WorldTrace<ProductSearch> world(scene, settings, kind, memory, counters);
  if (!settings.packets || is_published(settings.name) || rays.size() < 2) {
    for (std::size_t i = 0; i < rays.size(); ++i) use(world.trace(rays[i], any), i);
    return;
  }
  Hit hits[kPacket];
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    world.trace_packet(rays.subspan(first, count), any, hits);
    for (std::size_t i = 0; i < count; ++i) use(hits[i], first + i);
  }
}

void first_hits(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits, TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(true);
  trace_all(scene, settings, kind, false, rays, memory, counters,
            [&](const Hit& hit, std::size_t i) { hits[i] = hit; });
}

void occlusions(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, std::span<const Ray> rays,
                std::span<std::uint8_t> occluded, TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(false);
  trace_all(scene, settings, kind, true, rays, memory, counters,
            [&](const Hit& hit, std::size_t i) { occluded[i] = occlusion_of(hit); });
}

const TraceEntryPoints* entry_points() {
  static const TraceEntryPoints instance{
      hwy::TargetName(HWY_TARGET), {first_hits, occlusions}, blob_point, paper_point};
  return &instance;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "renderer/simd/vector_targets.h"

namespace isl::render {

const TraceEntryPoints* trace_entry_points(const std::string& name) {
  static constexpr VectorTarget<TraceEntryPoints> kTargets[] = {ISL_VECTOR_TARGETS(entry_points)};
  return entry_points_of<TraceEntryPoints>(kTargets, name);
}

}  // namespace isl::render
#endif
