// Lights that shine on some objects only: those of a `light_group` on the objects beside them. Objects of a light group
// are lit by the lights of the world only if it says `global_lights on`. Every object throws shadows in every light.
#include "renderer/effects/effect.h"

namespace isl::render {
namespace {

class LightGroupStage final : public Stage<ReachWork> {
 public:
  explicit LightGroupStage(const StageContext& context) : tracer_(context.tracer) {}

  void run(ReachWork& work) const override {
    for (std::size_t i = 0; i < work.samples.size(); ++i) {
      const std::uint32_t group = tracer_.light_group_of(work.batch.hits[work.block.paths[i]]);
      if (group == work.light_group) continue;
      const bool is_global = work.light_group == scene::kNone && tracer_.light_groups()[group].has_global_lights;
      if (!is_global) work.samples[i].strength = 0;
    }
  }

 private:
  const Tracer& tracer_;
};

}  // namespace

Effect light_group() {
  return {.name = "light_group",
          .summary = "lights that shine on some objects only",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                for (const Use<scene::Group>& group : use.groups()) {
                  if (group.record->is_light_group) requests.add("`light_group`", group.user);
                }
              },
          .stages = {.reach = make_stage<LightGroupStage, ReachWork>},
          .leave_out =
              [](scene::Database& database) {
                for (scene::Group& group : database.groups) group.is_light_group = false;
              }};
}

}  // namespace isl::render
