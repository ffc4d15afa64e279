// Fog of constant density. Over a distance s, the share e^(−s/distance) of the light from behind gets through, but at
// least the transmit of the fog's colour; the rest is the fog's colour. The colour tints the light that gets through,
// as far as its filter says. Several fogs attenuate one after the other, and their colours add up, as in POV-Ray. There
// is no fog inside objects that are not `hollow`.
#include "renderer/effects/effect.h"
#include "renderer/numerics/power.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

bool is_there(const scene::Fog& fog) { return fog.kind == scene::Fog::Kind::constant && fog.distance != 0; }

class FogStage final : public Stage<AlongWork> {
 public:
  explicit FogStage(const StageContext& context) {
    for (const scene::Fog& fog : context.database.fogs) {
      if (is_there(fog)) fogs_.push_back({rgb(fog.colour), fog.colour.filter, fog.colour.transmit, fog.distance});
    }
  }

  void run(AlongWork& work) const override {
    for (std::size_t i = 0; i < work.batch.size(); ++i) {
      PathEntry& path = work.batch.entries[i];
      if (path.in_solid) continue;
      Rgb through(1), added(0);
      for (const Layer& fog : fogs_) {
        const double share = std::max(power(std::numbers::e, -work.batch.hits[i].t / fog.distance), fog.least);
        through *= (Rgb(1 - fog.filter) + fog.colour * fog.filter) * share;
        added += fog.colour * (1 - share);
      }
      work.colours[path.sample] += path.factor * added;
      path.factor *= through;
    }
  }

 private:
  struct Layer {
    Rgb colour;
    double filter, least, distance;
  };
  std::vector<Layer> fogs_;
};

}  // namespace

Effect fog() {
  return {.name = "fog",
          .summary = "fog of constant density",
          .from_quality = 9,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "there is no fog of constant density";
                for (const scene::Fog& fog : use.database().fogs) {
                  if (is_there(fog)) requests.add("`fog`", fog.origin);
                }
              },
          .stages = {.along = make_stage<FogStage, AlongWork>}};
}

}  // namespace isl::render
