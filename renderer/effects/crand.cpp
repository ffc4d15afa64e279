// Grain: what a surface throws back of each light is darkened by a random part of `crand`, anew at each point. As in
// POV-Ray, clear surfaces are darkened as much as opaque ones.
#include "renderer/effects/requests.h"
#include "renderer/numerics/chance.h"

namespace isl::render {
namespace {

class GrainStage final : public Stage<LightWork> {
 public:
  explicit GrainStage(const StageContext& /*context*/) {}

  void run(LightWork& work) const override {
    const auto of_light = std::bit_cast<std::uint64_t>(work.light.location.x + work.light.location.y);
    for_each_lit_texture(work, [&](LitPoint& lit, const LitTexture& texture, double cosine, std::size_t) {
      const double amount = texture.material->finish->crand;
      const bool is_lit = (cosine > 0 ? texture.material->diffuse : texture.material->diffuse_back) > 0 && cosine != 0;
      if (!(amount > 0) || !is_lit) return;
      const ShadingPoint& point = work.block.points[lit.point];
      const auto layer = static_cast<std::uint64_t>(&texture - point.textures.data());
      const Vec3& place = point.position;
      const double dark = amount * chance_at(place.x, place.y, place.z, of_light + layer);
      lit.colour -= texture.colour * texture.let_through * (dark * texture.weight);
    });
  }
};

}  // namespace

Effect crand() {
  return {.name = "crand",
          .summary = "grain",
          .from_quality = 2,
          .find = find_finishes("`crand`", scene::FinishItem::crand,
                                [](const scene::Finish& finish) { return finish.crand > 0; }),
          .stages = {.diffuse = make_stage<GrainStage, LightWork>}};
}

}  // namespace isl::render
