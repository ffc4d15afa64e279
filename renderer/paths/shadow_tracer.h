// Traces shadow rays, whose light surfaces block or, where the scene has such surfaces, filter.
#pragma once

#include "renderer/paths/light_windows.h"
#include "renderer/paths/shadow_filter.h"
#include "renderer/trace/tracer.h"

#include <algorithm>

#include <span>
#include <vector>

namespace isl::render {

/// The means by which one thread traces shadow rays.
struct ShadowTracer {
  const Tracer& tracer;
  const ShadowFilter* filter;   ///< null if surfaces block all light
  const LightWindows* windows;  ///< null if no light has one
  PathLists& lists;             ///< of the paths
  ShadowFilterMemory& memory;
  TraceCounters& counters;

  /// shares[i] becomes the share of light that comes along rays[i], which begins in begin_in[i], and certainties[i] how
  /// sure that is. `occluded` is working memory.
  void run(std::span<const Ray> rays, std::span<const LightBegin> begin_in, std::span<Rgb> shares,
           std::span<Certainty> certainties, std::vector<std::uint8_t>& occluded) const {
    std::ranges::fill(certainties, Certainty::certified);
    if (filter) return filter->run(rays, RayKind::shadow, begin_in, shares, certainties, lists, memory, counters);
    occluded.resize(rays.size());
    tracer.occlusions(rays, occluded, counters);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      shares[i] = Rgb(occluded[i] == kOccluded ? 0 : 1);
      if (occluded[i] == kUndecidedOcclusion) certainties[i] = Certainty::undecided;
    }
  }
};

}  // namespace isl::render
