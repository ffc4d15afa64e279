// Light that other surfaces throw on a point, once: the light of a point at the other end of a ray, by the lights and
// from around, without highlights, mirrors and what lies behind glass. Directions are chosen by their cosines.
#include "renderer/effects/soft_rays.h"
#include "renderer/numerics/directions.h"

#include <numbers>

namespace isl::render {
namespace {

std::string bounce_mistake(SoftRays& rays) {
  return rays.distance < 0 ? "the `distance` of `bounce_light` must be above 0, or 0 for no limit" : "";
}

constexpr scene::StatementKind kBounceLight{.word = "bounce_light",
                                            .noun = "a bounce_light",
                                            .is_setting = true,
                                            .make = scene::make_record<SoftRays>,
                                            .fields = kSoftRaysFields,
                                            .check = scene::check_record<SoftRays, bounce_mistake>};

class BounceStage final : public Stage<SpawnWork> {
 public:
  explicit BounceStage(const StageContext& context)
      : rays_(find_statement(context.database, kBounceLight)->as<SoftRays>()) {}

  void run(SpawnWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      const std::uint32_t at = work.block.paths[i];
      const PathEntry& path = work.batch.entries[at];
      const PixelSample& sample = work.sample_of(path);
      const std::uint32_t share = sample.share_of(rays_.samples);
      for (std::uint32_t turn = 0; turn < share; ++turn) {
        const UnitPoint place = sample.point(SampleUse::bounce, share, turn, path.level);
        const Vec3 direction = cosine_direction(place, point.normal);
        const double density = direction.dot(point.normal) / std::numbers::pi;
        const Rgb factor = path.factor * thrown_back(work.block, point, direction) / (density * share);
        if (factor == Rgb(0)) continue;
        PathEntry child = path;
        child.factor = factor;
        child.kind = RayKind::around;
        ++child.level;
        work.send(ray_from(work.batch, at, point, direction, rays_.reach()), child);
      }
    }
  }

 private:
  const SoftRays& rays_;
};

}  // namespace

Effect bounce_light() {
  return {.name = "bounce_light",
          .summary = "light that surfaces throw on one another, once",
          .rays = "bounce",
          .from_quality = 5,
          .is_soft = true,
          .statement = &kBounceLight,
          .find = find_soft_rays(kBounceLight),
          .stages = {.spawn = make_stage<BounceStage, SpawnWork>}};
}

}  // namespace isl::render
