// Highlights: phong and specular, in the light's colour.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"

#include <algorithm>

namespace isl::render {
namespace {

class HighlightStage final : public Stage<LightWork> {
 public:
  explicit HighlightStage(const StageContext& /*context*/) {}

  void run(LightWork& work) const override {
    std::size_t count = 0;
    for (const LitPoint& lit : work.lit) count += work.block.points[lit.point].textures.size();
    work.shine.resize(count);
    if (!work.cosines.empty()) return run_each(work);
    Rgb* shine = work.shine.data();
    for (const LitPoint& lit : work.lit) {
      const ShadingPoint& point = work.block.points[lit.point];
      HighlightAngles angle;
      if (std::ranges::any_of(point.textures,
                              [](const LitTexture& texture) { return has_highlights(*texture.material); }))
        angle = highlight_angles(point.normal, point.view, lit.light.direction);
      for (const LitTexture& texture : point.textures) *shine++ = Rgb(highlight(*texture.material, angle));
    }
  }

 private:
  /// The same where every texture has a normal of its own, or is lit from behind, which makes no highlights.
  static void run_each(LightWork& work) {
    for_each_lit_texture(work, [&](const LitPoint& lit, const LitTexture& texture, double cosine, std::size_t i) {
      work.shine[i] = Rgb(0);
      if (!(cosine > 0) || !has_highlights(*texture.material)) return;
      const ShadingPoint& point = work.block.points[lit.point];
      const Vec3& normal = work.block.normal_of(point, texture);
      work.shine[i] = Rgb(highlight(*texture.material, highlight_angles(normal, point.view, lit.light.direction)));
    });
  }
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
