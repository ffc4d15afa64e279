// `use_alpha` of a finish: where its pigment is transparent, so are its highlights and its reflection
// (SurfaceBlock::surface_share_of).
#include "renderer/effects/requests.h"

namespace isl::render {
namespace {

class AlphaStage final : public Stage<LightWork> {
 public:
  explicit AlphaStage(const StageContext& /*context*/) {}

  void run(LightWork& work) const override {
    if (work.shine.empty()) return;  // highlights are left out of the picture
    for_each_lit_texture(work, [&](const LitPoint&, const LitTexture& texture, double, std::size_t i) {
      work.shine[i] *= work.block.surface_share_of(texture);
    });
  }
};

bool hides_surface(const scene::Finish& finish) {
  return finish.use_alpha && (finish.phong > 0 || finish.specular > 0 || reflects(finish));
}

}  // namespace

Effect use_alpha() {
  return {.name = "use_alpha",
          .summary = "highlights and reflections as transparent as the pigment",
          .from_quality = 2,
          .find = find_finishes("`use_alpha`", scene::FinishItem::use_alpha, hides_surface),
          .stages = {.shine = make_stage<AlphaStage, LightWork>, .passing = true, .opacities = true},
          .leave_out = [](scene::Database& database) {
            for (scene::Finish& finish : database.finishes) finish.use_alpha = false;
          }};
}

}  // namespace isl::render
