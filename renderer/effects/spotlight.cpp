// Spotlights: light within a cone about the axis. It is full within `radius`, and falls smoothly to nothing at
// `falloff`; with `tightness` it falls with the angle everywhere. A parallel spotlight has no cone, as in POV-Ray.
#include "renderer/effects/requests.h"
#include "renderer/numerics/power.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

bool has_cone(const scene::Light& light) { return light.kind == scene::LightKind::spotlight && !light.parallel; }

double strength_in_cone(const scene::Light& light, double cosine) {
  const double full = std::cos(light.radius), none = std::cos(light.falloff);
  // A `radius` above `falloff` is that of a cone with a sharp edge.
  if (!(cosine > std::min(full, none)) || !(cosine > 0)) return 0;
  const double strength = light.tightness == 0 ? 1 : power(cosine, light.tightness);
  if (cosine >= full) return strength;
  const double x = (cosine - none) / (full - none);
  return strength * x * x * (3 - 2 * x);
}

class SpotStage final : public Stage<ReachWork> {
 public:
  explicit SpotStage(const StageContext& /*context*/) {}

  void run(ReachWork& work) const override {
    if (!has_cone(work.light)) return;
    const Vec3 axis = axis_of(work.light);
    for (LightSample& sample : work.samples)
      sample.strength *= strength_in_cone(work.light, -sample.direction.dot(axis));
  }
};

}  // namespace

Effect spotlight() {
  return {.name = "spotlight",
          .summary = "light within a cone",
          .from_quality = 2,
          .find = find_lights("`spotlight`", scene::LightItem::kind, has_cone),
          .stages = {.reach = make_stage<SpotStage, ReachWork>}};
}

}  // namespace isl::render
