// Surfaces that shine by themselves: pigment × emission, whatever light there is.
#include "renderer/effects/light_requests.h"
#include "renderer/effects/requests.h"

namespace isl::render {
namespace {

class EmissionStage final : public Stage<SurfaceWork> {
 public:
  explicit EmissionStage(const StageContext& /*context*/) {}

  void run(SurfaceWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      Rgb colour(0);
      for (const LitTexture& lit : work.block.points[i].textures)
        colour += lit.pigment * lit.let_through * rgb(lit.material->finish->emission) * lit.weight;
      const PathEntry& path = work.batch.entries[work.block.paths[i]];
      work.colours[path.sample] += path.factor * colour;
    }
  }
};

}  // namespace

Effect emission() {
  return {.name = "emission",
          .summary = "surfaces that shine by themselves",
          .from_quality = 2,
          .find = find_finishes("`emission`", scene::FinishItem::emission,
                                [](const scene::Finish& finish) { return shines(finish.emission); }),
          .stages = {.own_light = make_stage<EmissionStage, SurfaceWork>}};
}

}  // namespace isl::render
