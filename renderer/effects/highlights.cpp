// Highlights: phong and specular, in the light's colour. A finish with `fresnel` mirrors no more of the light than its
// index of refraction says.
#include "renderer/shading/highlights.h"
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"
#include "renderer/shading/mirror.h"

#include <algorithm>

namespace isl::render {
namespace {

class HighlightStage final : public Stage<LightWork> {
 public:
  explicit HighlightStage(const StageContext& context) : has_fresnel_(any_fresnel(context.database)) {}

  void run(LightWork& work) const override {
    std::size_t count = 0;
    for (const LitPoint& lit : work.lit) count += work.block.points[lit.point].textures.size();
    work.shine.assign(count, Rgb(0));
    Highlights highlights;
    // A light from behind makes no highlights.
    for_each_lit_texture(work, [&](const LitPoint& lit, const LitTexture& texture, double cosine, std::size_t i) {
      if (!(cosine > 0)) return;
      const ShadingPoint& point = work.block.points[lit.point];
      const Vec3& normal = work.block.normal_of(point, texture);
      const scene::Finish& finish = *texture.material->finish;
      if (has_fresnel_ && finish.fresnel != 0) [[unlikely]] {
        highlights.add(*texture.material, normal, point.view, lit.light.direction, work.shine[i],
                       [&](double at) { return mirrored_by(finish, at, point.ior_ratio); });
      } else {
        highlights.add(*texture.material, normal, point.view, lit.light.direction, work.shine[i]);
      }
    });
    highlights.finish();
  }

 private:
  bool has_fresnel_;
};

}  // namespace

Effect highlights() {
  return {.name = "highlights",
          .summary = "phong and specular highlights",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "every light is shadowless";
                const bool has_light =
                    std::ranges::any_of(use.lights(), [](const auto& light) { return is_full(*light.record); });
                if (!has_light) return;
                reason = "no finish has phong or specular";
                for (const Use<scene::Finish>& finish : use.finishes()) {
                  if (finish.record->phong > 0)
                    requests.add("`phong`", finish.record->said_at[scene::FinishItem::phong], finish.user);
                  if (finish.record->specular > 0)
                    requests.add("`specular`", finish.record->said_at[scene::FinishItem::specular], finish.user);
                }
              },
          .stages = {.shine = make_stage<HighlightStage, LightWork>}};
}

}  // namespace isl::render
