// Light that fades with the distance d: × 2/(1 + (d/fade_distance)^fade_power), so that it is 1 at fade_distance and up
// to 2 nearer; or × d^−fade_power at all distances, as physics has it with the power 2.
#include "renderer/effects/requests.h"
#include "renderer/numerics/power.h"

namespace isl::render {
namespace {

bool fades(const scene::Light& light) {
  return light.fade_power > 0 && (light.fade_distance > 0 || light.fades_from_point);
}

class FadingStage final : public Stage<ReachWork> {
 public:
  explicit FadingStage(const StageContext& /*context*/) {}

  void run(ReachWork& work) const override {
    if (!fades(work.light)) return;
    const double exponent = work.light.fade_power;
    if (work.light.fades_from_point) {
      for (LightSample& sample : work.samples) sample.strength /= power(sample.distance, exponent);
    } else {
      for (LightSample& sample : work.samples)
        sample.strength *= 2 / (1 + power(sample.distance / work.light.fade_distance, exponent));
    }
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
