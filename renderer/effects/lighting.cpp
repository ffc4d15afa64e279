// Diffuse light: light colour × diffuse × (N·L)^brilliance × pigment, from every light that a point faces.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"

namespace isl::render {
namespace {

class DiffuseStage final : public Stage<LightWork> {
 public:
  explicit DiffuseStage(const StageContext& /*context*/) {}

  void run(LightWork& work) const override {
    if (work.cosines.empty()) {
      for (LitPoint& lit : work.lit) lit.colour = diffuse_colour(work.block.points[lit.point], lit.incidence);
      return;
    }
    for_each_lit_texture(work, [](LitPoint& lit, const LitTexture& texture, double cosine, std::size_t) {
      lit.colour += texture.pigment * texture.let_through * (diffuse_share(*texture.material, cosine) * texture.weight);
    });
  }
};

}  // namespace

Effect lighting() {
  return {.name = "lighting",
          .summary = "diffuse light",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no light shines";
                for (const Use<scene::Light>& light : use.lights()) {
                  if (shines(*light.record)) requests.add("a light", light.user);
                }
              },
          .stages = {.diffuse = make_stage<DiffuseStage, LightWork>}};
}

}  // namespace isl::render
