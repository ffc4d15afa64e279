// Diffuse light from the sky and the background, in place of ambient light: ∫ L(ω) V(ω) diffuse pigment cos θ/π dω,
// where V is 0 in directions in which something lies within the distance.
#include "renderer/effects/sky_source.h"
#include "renderer/effects/soft_rays.h"

namespace isl::render {
namespace {

std::string sky_mistake(SoftRays& rays) {
  return rays.distance < 0 ? "the `distance` of `sky_light` must be above 0, or 0 for no limit" : "";
}

constexpr scene::StatementKind kSkyLight{.word = "sky_light",
                                         .noun = "a sky_light",
                                         .is_setting = true,
                                         .make = scene::make_record<SoftRays>,
                                         .fields = kSoftRaysFields,
                                         .check = scene::check_record<SoftRays, sky_mistake>};

class SkyLightStage final : public Stage<AroundWork> {
 public:
  explicit SkyLightStage(const StageContext& context)
      : rays_(find_statement(context.database, kSkyLight)->as<SoftRays>()) {}

  void run(AroundWork& work) const override {
    std::vector<Vec3>& directions = work.directions;
    std::vector<Rgb>& colours = work.colours;
    directions.clear();
    colours.clear();
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      const PathEntry& path = work.batch.entries[work.block.paths[i]];
      const PixelSample& sample = work.sample_of(path);
      const std::uint32_t share = sample.share_of(rays_.samples);
      directions.push_back(point.normal);
      colours.emplace_back(0);
      if (work.turn >= share) continue;
      work.is_last &= work.turn + 1 == share;
      const UnitPoint place = sample.point(SampleUse::sky, share, work.turn, path.level);
      const SkySource::Choice choice = work.sky->choose(place, point.normal);
      if (!(choice.direction.dot(point.normal) > 0)) continue;
      directions.back() = choice.direction;
      colours.back() = path.factor * thrown_back(work.block, point, choice.direction) / (choice.density * share);
    }
    work.light.resize(directions.size());
    work.sky->light(directions, work.light, work.scratch);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Rgb colour = colours[i] * work.light[i];
      if (colour == Rgb(0)) continue;
      const std::uint32_t at = work.block.paths[i];
      work.rays.push(work.batch.entries[at],
                     ray_from(work.batch, at, work.block.points[i], directions[i], rays_.reach()), colour);
    }
  }

 private:
  const SoftRays& rays_;
};

}  // namespace

Effect sky_light() {
  return {.name = "sky_light",
          .summary = "light from the sky and the background in place of ambient light",
          .from_quality = 5,
          .is_soft = true,
          .replaces = "ambient",
          .statement = &kSkyLight,
          .find = find_soft_rays(kSkyLight),
          .stages = {.around = make_stage<SkyLightStage, AroundWork>, .sky = true}};
}

}  // namespace isl::render
