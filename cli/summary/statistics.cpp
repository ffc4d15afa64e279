#include "cli/summary/statistics.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace isl::cli {
namespace {

/// The greatest memory size that the process ever had.
std::size_t peak_bytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

nlohmann::ordered_json names_of(const std::vector<render::PlannedEffect>& effects) {
  auto names = nlohmann::ordered_json::array();
  for (const render::PlannedEffect& planned : effects) names.push_back(planned.effect->name);
  return names;
}

}  // namespace

nlohmann::ordered_json statistics_json(const SceneSummary& scene, const PhaseTimes& times,
                                       const RenderSettings& settings, const MemoryUse& memory,
                                       const render::RenderStatistics& render) {
  nlohmann::ordered_json document;
  document["scene"] = {
      {"primitives", scene.primitives()}, {"fields", scene.fields}, {"solids", scene.solids}, {"lights", scene.lights}};
  document["time"] = {{"parse", times.parse},
                      {"evaluate", times.evaluate},
                      {"compile", times.compile},
                      {"trace", times.trace},
                      {"write", times.write}};
  document["rays"] = {
      {"camera", render.paths.camera}, {"shadow", render.paths.shadow}, {"around", render.paths.around}};
  for (const render::Effect& effect : render::all_effects()) {
    if (!effect.rays.empty()) document["rays"][effect.rays] = render::spawned_rays(render.plan, render.paths, effect);
  }
  document["paths"] = {{"ended_by_level", render.paths.ended.by_level},
                       {"ended_by_weight", render.paths.ended.by_weight}};
  document["solver"] = {{"name", to_text(settings.solver)},
                        {"tolerance", settings.tolerance_text},
                        {"field_evaluations", render.counters.field_evaluations},
                        {"shading_evaluations", render.counters.shading_evaluations},
                        {"uncertified_steps", render.counters.uncertified_steps},
                        {"most_ray_steps", render.counters.most_ray_steps},
                        {"spent_rays", render.counters.spent_rays},
                        {"undecided_pixels", render.undecided_pixels},
                        {"refuted_pixels", render.refuted_pixels}};
  document["memory"] = {
      {"peak_bytes", peak_bytes()}, {"database_bytes", memory.database_bytes}, {"grid_bytes", memory.grid_bytes}};
  document["effects"] = {{"called_for", names_of(render.plan.called_for)},
                         {"left_out", names_of(render.plan.left_out)}};
  document["threads"] = render.threads;
  document["samples_per_pixel"] = render.samples_per_pixel;
  document["lost"] = {{"samples", render.lost.samples}, {"pixels", render.lost.pixels}};
  if (settings.render.max_noise)
    document["noise"] = {{"asked", *settings.render.max_noise}, {"noisy_pixels", render.noisy_pixels}};
  return document;
}

}  // namespace isl::cli
