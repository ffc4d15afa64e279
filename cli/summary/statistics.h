// The work and the cost of a render, as the JSON document of --stats.
#pragma once

#include "cli/options/render_settings.h"
#include "cli/summary/scene_summary.h"
#include "renderer/render.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>

namespace isl::cli {

/// Wall-clock seconds of each phase.
struct PhaseTimes {
  double parse = 0;
  double evaluate = 0;
  double compile = 0;
  double trace = 0;
  double write = 0;
};

struct MemoryUse {
  std::size_t database_bytes = 0;
  std::size_t grid_bytes = 0;
};

[[nodiscard]] nlohmann::ordered_json statistics_json(const SceneSummary& scene, const PhaseTimes& times,
                                                     const RenderSettings& settings, const MemoryUse& memory,
                                                     const render::RenderStatistics& render);

}  // namespace isl::cli
