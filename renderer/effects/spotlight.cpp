// Spotlights: light within a cone about the axis. It is full within `radius`, and falls smoothly to nothing at
// `falloff`; with `tightness` it falls with the angle everywhere. A parallel spotlight has no cone, as in POV-Ray.
#include "renderer/effects/requests.h"
#include "renderer/numerics/power.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

bool has_cone(const scene::Light& light) { return light.kind == scene::LightKind::spotlight && !light.parallel; }

class Cone {
 public:
  explicit Cone(const scene::Light& light)
      : axis_(axis_of(light)),
        tightness_(light.tightness),
        full_(std::cos(light.radius)),
        none_(std::cos(light.falloff)) {}

  /// The share of the light that goes this way from it.
  [[nodiscard]] double strength_towards(const Vec3& direction) const {
    const double cosine = direction.dot(axis_);
    // A `radius` above `falloff` is that of a cone with a sharp edge.
    if (!(cosine > std::min(full_, none_)) || !(cosine > 0)) return 0;
    const double strength = tightness_ == 0 ? 1 : power(cosine, tightness_);
    if (cosine >= full_) return strength;
    const double x = (cosine - none_) / (full_ - none_);
    return strength * x * x * (3 - 2 * x);
  }

 private:
  Vec3 axis_;
  double tightness_;
  double full_, none_;  ///< cosines of the angles at which the light begins to fall, and ends
};

class SpotStage final : public Stage<ReachWork> {
 public:
  explicit SpotStage(const StageContext& /*context*/) {}

  void run(ReachWork& work) const override {
    if (!has_cone(work.light)) return;
    const Cone cone(work.light);
    for (LightSample& sample : work.samples) sample.strength *= cone.strength_towards(-sample.direction);
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
