// Colours of thin films, such as oil or soap. The film changes the light that each light source adds, and reflections
// (reflection.cpp asks for its factor); formulas: shading/irid.h.
#include "renderer/shading/irid.h"
#include "renderer/effects/requests.h"

namespace isl::render {
namespace {

/// The factor of a texture on a lit point.
Rgb film_at(const LightWork& work, const FilmLight& film, const LitPoint& lit, const LitTexture& texture,
            double cosine) {
  const ShadingPoint& point = work.block.points[lit.point];
  const double out = work.block.normal_of(point, texture).dot(point.view);
  return film_factor(*texture.material->finish, film, point.position, out, cosine);
}

/// Adds what the film changes in the diffuse light, after that light itself.
class DiffuseFilmStage final : public Stage<LightWork> {
 public:
  explicit DiffuseFilmStage(const StageContext& context) : film_(context.database.settings) {}

  void run(LightWork& work) const override {
    for_each_lit_texture(work, [&](LitPoint& lit, const LitTexture& texture, double cosine, std::size_t) {
      if (texture.material->finish->irid == 0 || cosine == 0) return;
      const Rgb change = film_at(work, film_, lit, texture, cosine) - Rgb(1);
      const double share = diffuse_share(*texture.material, cosine) * texture.weight;
      lit.colour += texture.pigment * texture.let_through * change * share;
    });
  }

 private:
  FilmLight film_;
};

class HighlightFilmStage final : public Stage<LightWork> {
 public:
  explicit HighlightFilmStage(const StageContext& context) : film_(context.database.settings) {}

  void run(LightWork& work) const override {
    if (work.shine.empty()) return;  // highlights are left out of the picture
    for_each_lit_texture(work, [&](const LitPoint& lit, const LitTexture& texture, double cosine, std::size_t i) {
      if (texture.material->finish->irid != 0) work.shine[i] *= film_at(work, film_, lit, texture, cosine);
    });
  }

 private:
  FilmLight film_;
};

}  // namespace

Effect irid() {
  return {.name = "irid",
          .summary = "colours of thin films",
          .from_quality = 2,
          .find = find_finishes("`irid`", scene::FinishItem::irid,
                                [](const scene::Finish& finish) { return finish.irid != 0; }),
          .stages = {.diffuse = make_stage<DiffuseFilmStage, LightWork>,
                     .shine = make_stage<HighlightFilmStage, LightWork>},
          .leave_out = [](scene::Database& database) {
            for (scene::Finish& finish : database.finishes) finish.irid = 0;
          }};
}

}  // namespace isl::render
