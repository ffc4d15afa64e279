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
#include "renderer/trace/packet_trace-inl.h"

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
                         TraceCounters& counters, const OctetBlobRays& rays, std::uint32_t in_use,
                         OctetBlobHits& hits) {
    PacketSearch(blob, settings, rays, memory.lanes, memory.packets, counters).first_hits(in_use, hits);
  }
};

/// True if rays go in packets.
[[nodiscard]] bool in_packets(const SolverSettings& settings, std::span<const Ray> rays) {
  return settings.packets && !is_published(settings.name) && rays.size() > 1;
}

void first_hits(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits, TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(true);
  if (!in_packets(settings, rays)) {
    SingleTrace<ProductSearch> world(scene, settings, kind, memory, counters);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = world.trace(rays[i], false);
    return;
  }
  PacketTrace<ProductSearch> world(scene, settings, kind, memory, counters);
  for (std::size_t first = 0; first < rays.size(); first += kPacket)
    world.first_hits(rays.subspan(first, std::min(kPacket, rays.size() - first)), &hits[first]);
}

void occlusions(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, std::span<const Ray> rays,
                std::span<std::uint8_t> occluded, TraceMemory& memory, TraceCounters& counters) {
  memory.paper.begin_batch(false);
  if (!in_packets(settings, rays)) {
    SingleTrace<ProductSearch> world(scene, settings, kind, memory, counters);
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = occlusion_of(world.trace(rays[i], true));
    return;
  }
  PacketTrace<ProductSearch> world(scene, settings, kind, memory, counters);
  for (std::size_t first = 0; first < rays.size(); first += kPacket)
    world.occlusions(rays.subspan(first, std::min(kPacket, rays.size() - first)), &occluded[first]);
}

const TraceEntryPoints* entry_points() {
  static const TraceEntryPoints instance{
      hwy::TargetName(HWY_TARGET), {first_hits, occlusions}, blob_point, blob_fields, paper_point};
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
