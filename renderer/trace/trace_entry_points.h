// The inner loops, compiled once for every vector width and chosen at run time. See trace_entry_points.cpp.
#pragma once

#include "renderer/compiled/compiled_scene.h"
#include "renderer/fields/point/blob_point.h"
#include "renderer/fields/ray/lane_memory.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/ray.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/certified/packet_memory.h"
#include "renderer/solvers/published/paper_memory.h"
#include "renderer/trace/csg_search.h"

#include <span>
#include <vector>

namespace isl::render {

/// Memory that a thread reuses from ray to ray.
struct TraceMemory {
  LaneMemory lanes;
  PacketMemory packets;
  PaperMemory paper;
  CsgMemory csg;
  BlobPoint point;
  std::vector<CoincidingHit>* coinciding = nullptr;  ///< see Tracer::first_hits()
};

/// The functions that trace rays.
struct TraceLoops {
  void (*first_hits)(const CompiledScene&, const SolverSettings&, RayKind, std::span<const Ray>, std::span<Hit>,
                     TraceMemory&, TraceCounters&);
  void (*occlusions)(const CompiledScene&, const SolverSettings&, RayKind, std::span<const Ray>,
                     std::span<std::uint8_t>, TraceMemory&, TraceCounters&);
};

struct TraceEntryPoints {
  const char* target;
  TraceLoops loops;  ///< for the product's solver and the published one
  void (*blob_point)(const CompiledBlob&, std::uint32_t cell, const Vec3& point, const ShareRule&, BlobPoint&);
  std::uint64_t (*blob_fields)(const CompiledBlob&, std::span<const FieldQuery>, std::span<BlobFields>);
  void (*paper_point)(const CompiledBlob&, std::uint32_t cell, const PaperMemory* records, bool eq10, const Vec3& point,
                      const ShareRule&, BlobPoint&);
};

/// The entry points for the widest vectors that this machine has, or for the target named ("AVX3", "AVX2", "SSE4", …).
/// Null if the machine or the program lacks it.
[[nodiscard]] const TraceEntryPoints* trace_entry_points(const std::string& target);

}  // namespace isl::render
