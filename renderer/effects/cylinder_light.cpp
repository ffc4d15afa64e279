// Beams: parallel light within a cylinder about the axis. It is full within `radius`, and falls smoothly to nothing at
// `falloff`; with `tightness` it falls with the distance from the axis everywhere.
#include "renderer/effects/requests.h"
#include "renderer/numerics/power.h"

namespace isl::render {
namespace {

bool is_beam(const scene::Light& light) { return light.kind == scene::LightKind::cylinder; }

double strength_in_beam(const scene::Light& light, double from_axis) {
  const double left = 1 - from_axis / light.falloff;
  if (!(left > 0)) return 0;
  const double strength = light.tightness == 0 ? 1 : power(left, light.tightness);
  if (!(from_axis > light.radius)) return strength;
  const double x = left / (1 - light.radius / light.falloff);
  return strength * x * x * (3 - 2 * x);
}

class BeamStage final : public Stage<ReachWork> {
 public:
  explicit BeamStage(const StageContext& /*context*/) {}

  void run(ReachWork& work) const override {
    if (!is_beam(work.light)) return;
    for (std::size_t i = 0; i < work.samples.size(); ++i) {
      LightSample& sample = work.samples[i];
      // The sample's way leads to the plane through the light, beside the light by the distance from the axis.
      const Vec3 aside = work.block.points[i].position + sample.direction * sample.distance - work.light.location;
      sample.strength *= strength_in_beam(work.light, aside.length());
    }
  }
};

}  // namespace

Effect cylinder_light() {
  return {.name = "cylinder_light",
          .summary = "light within a cylinder",
          .from_quality = 2,
          .find = find_lights("a `cylinder` of light", scene::LightItem::kind, is_beam),
          .stages = {.reach = make_stage<BeamStage, ReachWork>},
          .leave_out = change_lights([](scene::Light& light) {
            if (is_beam(light)) light.kind = scene::LightKind::point;
          })};
}

}  // namespace isl::render
