// Pigments as they are, without any light. The lowest qualities show these.
#include "renderer/effects/effect.h"

namespace isl::render {
namespace {

class PlainColourStage final : public Stage<SurfaceWork> {
 public:
  explicit PlainColourStage(const StageContext& /*context*/) {}

  void run(SurfaceWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const PathEntry& path = work.batch.entries[work.block.paths[i]];
      work.colours[path.sample] += path.factor * plain_colour(work.block.points[i]);
    }
  }
};

}  // namespace

Effect plain_colours() {
  return {.name = "plain_colours",
          .summary = "pigments without light",
          .to_quality = 1,
          .find = [](const SceneUse& /*use*/, Requests& requests,
                     std::string_view& /*reason*/) { requests.add("the quality", {}); },
          .stages = {.own_light = make_stage<PlainColourStage, SurfaceWork>}};
}

}  // namespace isl::render
