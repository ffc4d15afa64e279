// Light that fades with the distance d: × 2/(1 + (d/fade_distance)^fade_power), so that it is 1 at fade_distance and up
// to 2 nearer.
#include "renderer/effects/requests.h"
#include "renderer/numerics/power.h"

namespace isl::render {
namespace {

bool fades(const scene::Light& light) { return light.fade_distance > 0 && light.fade_power > 0; }

class FadingStage final : public Stage<ReachWork> {
 public:
  explicit FadingStage(const StageContext& /*context*/) {}

  void run(ReachWork& work) const override {
    if (!fades(work.light)) return;
    for (LightSample& sample : work.samples)
      sample.strength *= 2 / (1 + power(sample.distance / work.light.fade_distance, work.light.fade_power));
  }
};

}  // namespace

Effect fading_light() {
  return {.name = "fading_light",
          .summary = "light that fades with the distance",
          .from_quality = 2,
          .find = find_lights("`fade_distance`", scene::LightItem::fade, fades),
          .stages = {.reach = make_stage<FadingStage, ReachWork>}};
}

}  // namespace isl::render
