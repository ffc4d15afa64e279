// `fresnel` of a finish: its surface mirrors light as its index of refraction says, and what it mirrors is lost to what
// lies below. Highlights are reduced to the share that is mirrored (highlights.cpp), and diffuse light loses it as it
// falls in (lighting.cpp) and as it leaves: with the light's own and with that from around, it leaves at the angle of
// the view, so that the pigment is dimmed once for all of them here.
#include "renderer/effects/requests.h"
#include "renderer/shading/mirror.h"

namespace isl::render {
namespace {

class LeavingStage final : public Stage<TextureWork> {
 public:
  explicit LeavingStage(const StageContext& /*context*/) {}

  void run(TextureWork& work) const override {
    for (const ShadingPoint& point : work.block.points) {
      for (const LitTexture& lit : point.textures) {
        const scene::Finish& finish = *lit.material->finish;
        if (finish.fresnel == 0) continue;
        const double cosine = -work.block.normal_of(point, lit).dot(point.view);
        LitTexture& texture = work.textures[static_cast<std::size_t>(&lit - work.textures.data())];
        texture.pigment *= 1 - mirrored_by(finish, cosine, point.ior_ratio);
      }
    }
  }
};

}  // namespace

Effect fresnel_finish() {
  return {.name = "fresnel_finish",
          .summary = "diffuse light and highlights by the index of refraction",
          .from_quality = 2,
          .find = find_finishes("`fresnel` of a finish", scene::FinishItem::fresnel,
                                [](const scene::Finish& finish) { return finish.fresnel != 0; }),
          .stages = {.textures = make_stage<LeavingStage, TextureWork>, .fresnel = true},
          .leave_out = [](scene::Database& database) {
            for (scene::Finish& finish : database.finishes) finish.fresnel = 0;
          }};
}

}  // namespace isl::render
