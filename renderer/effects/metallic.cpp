// Metallic finishes: highlights take the pigment's colour, less so at grazing angles (shading/metal.h).
#include "renderer/effects/effect.h"
#include "renderer/shading/metal.h"

#include <algorithm>

namespace isl::render {
namespace {

class MetallicStage final : public Stage<LightWork> {
 public:
  explicit MetallicStage(const StageContext& /*context*/) {}

  void run(LightWork& work) const override {
    if (work.shine.empty()) return;  // highlights are left out of the picture
    for_each_lit_texture(work, [&](const LitPoint&, const LitTexture& texture, double cosine, std::size_t i) {
      const double amount = texture.material->finish->metallic;
      if (amount != 0) work.shine[i] *= metal_tint(amount, cosine, texture.colour);
    });
  }
};

}  // namespace

Effect metallic() {
  return {.name = "metallic",
          .summary = "highlights in the metal's own colour",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no finish with a highlight is metallic";
                for (const Use<scene::Finish>& finish : use.finishes()) {
                  const bool has_highlight = finish.record->phong > 0 || finish.record->specular > 0;
                  if (has_highlight && finish.record->metallic != 0)
                    requests.add("`metallic`", finish.record->said_at[scene::FinishItem::metallic], finish.user);
                }
              },
          .stages = {.shine = make_stage<MetallicStage, LightWork>}};
}

}  // namespace isl::render
