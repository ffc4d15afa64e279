// Diffuse light: light colour × diffuse × (N·L)^brilliance × pigment, from every light that a point faces. Light that
// falls on a finish with `fresnel` loses the share that its surface mirrors.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"
#include "renderer/shading/mirror.h"

namespace isl::render {
namespace {

class DiffuseStage final : public Stage<LightWork> {
 public:
  explicit DiffuseStage(const StageContext& context) : has_fresnel_(any_fresnel(context.database)) {}

  void run(LightWork& work) const override {
    if (has_fresnel_) return run_with_fresnel(work);
    if (work.cosines.empty()) {
      for (LitPoint& lit : work.lit) lit.colour = diffuse_colour(work.block.points[lit.point], lit.incidence);
      return;
    }
    for_each_lit_texture(work, [](LitPoint& lit, const LitTexture& texture, double cosine, std::size_t) {
      lit.colour += texture.pigment * texture.let_through * (diffuse_share(*texture.material, cosine) * texture.weight);
    });
  }

 private:
  static void run_with_fresnel(LightWork& work) {
    for_each_lit_texture(work, [&](LitPoint& lit, const LitTexture& texture, double cosine, std::size_t) {
      const double ratio = work.block.points[lit.point].ior_ratio;
      const double entering = 1 - mirrored_by(*texture.material->finish, cosine, ratio);
      const double share = diffuse_share(*texture.material, cosine) * entering;
      lit.colour += texture.pigment * texture.let_through * (share * texture.weight);
    });
  }

  bool has_fresnel_;
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
