// Light that comes from everywhere: pigment × finish ambient × ambient_light, whatever stands around. It is replaced by
// the pigment itself at the lowest qualities, which show no light at all.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"

namespace isl::render {
namespace {

class AmbientStage final : public Stage<SurfaceWork> {
 public:
  explicit AmbientStage(const StageContext& /*context*/) {}

  void run(SurfaceWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const PathEntry& path = work.batch.entries[work.block.paths[i]];
      work.colours[path.sample] += path.factor * ambient_colour(work.block.points[i]);
    }
  }
};

}  // namespace

Effect ambient() {
  return {.name = "ambient",
          .summary = "light from everywhere",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                const scene::Database& database = use.database();
                reason = "no finish in use has an ambient part";
                if (!shines(database.settings.ambient_light)) reason = "`ambient_light` is black";
                if (!shines(database.settings.ambient_light)) return;
                for (const Use<scene::Texture>& texture : use.textures()) {
                  const scene::Finish& finish = database.finish(texture.record->finish);
                  if (shines(finish.ambient))
                    requests.add("`ambient` of a finish", finish.said_at[scene::FinishItem::ambient], texture.user);
                }
              },
          .stages = {.own_light = make_stage<AmbientStage, SurfaceWork>}};
}

}  // namespace isl::render
