// Ambient light that surfaces nearby keep away: a point gets the share of it that comes from directions, weighed by
// their cosines, in which nothing lies within the distance.
#include "renderer/effects/soft_rays.h"
#include "renderer/numerics/directions.h"

namespace isl::render {
namespace {

std::string occlusion_mistake(SoftRays& rays) {
  return rays.distance > 0 ? "" : "`ambient_occlusion` needs a `distance` above 0";
}

constexpr scene::StatementKind kOcclusion{.word = "ambient_occlusion",
                                          .noun = "an ambient_occlusion",
                                          .is_setting = true,
                                          .make = scene::make_record<SoftRays>,
                                          .fields = kSoftRaysFields,
                                          .check = scene::check_record<SoftRays, occlusion_mistake>};

class OcclusionStage final : public Stage<AroundWork> {
 public:
  explicit OcclusionStage(const StageContext& context)
      : rays_(find_statement(context.database, kOcclusion)->as<SoftRays>()) {}

  void run(AroundWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      const std::uint32_t at = work.block.paths[i];
      const PathEntry& path = work.batch.entries[at];
      const PixelSample& sample = work.sample_of(path);
      const std::uint32_t share = sample.share_of(rays_.samples);
      if (work.turn >= share) continue;
      work.is_last &= work.turn + 1 == share;
      const Rgb light = path.factor * ambient_colour(point);
      if (light == Rgb(0)) continue;
      const UnitPoint place = sample.point(SampleUse::occlusion, share, work.turn, path.level);
      const Vec3 direction = cosine_direction(place, point.normal);
      work.rays.push(path, ray_from(work.batch, at, point, direction, rays_.reach()), light / share);
    }
  }

 private:
  const SoftRays& rays_;
};

}  // namespace

Effect ambient_occlusion() {
  return {.name = "ambient_occlusion",
          .summary = "ambient light that surfaces nearby keep away",
          .from_quality = 5,
          .is_soft = true,
          .replaces = "ambient",
          .statement = &kOcclusion,
          .find = find_soft_rays(kOcclusion),
          .stages = {.around = make_stage<OcclusionStage, AroundWork>}};
}

}  // namespace isl::render
