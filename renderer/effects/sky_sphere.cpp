// The sky: pigments looked up at the ray's direction, as points of a unit sphere. Each layer shows the opaque part of
// its colour and lets through the rest; the background lies under the last.
//
// The light that passes the layers above, as observed in POV-Ray 3.7, where c are these layers' colours, f filters and
// t transmits:
//   - from version 3.7 on, Π (c f + t), as transparent layers do elsewhere;
//   - before, Π f + Π t of the layers below, and Π c f + Π t of the background: layers are dimmed but not coloured.
#include "renderer/effects/effect.h"

#include <algorithm>
#include <optional>

namespace isl::render {
namespace {

/// The first pigment lies at the bottom.
struct Sky {
  std::vector<scene::Pigment> pigments;
  scene::Colour emission{1, 1, 1};
  scene::TransformId world_from_sky = scene::kIdentity;
};

constexpr scene::StatementField kSkyFields[] = {
    scene::field<&Sky::pigments>("pigment").with_key("pigments"),
    scene::field<&Sky::emission>("emission"),
    scene::field<&Sky::world_from_sky>("").with_key("transform"),
};

std::string with_pigment(Sky& sky) { return sky.pigments.empty() ? "a `sky_sphere` needs a `pigment`" : ""; }

constexpr scene::StatementKind kSky{.word = "sky_sphere",
                                    .noun = "a sky_sphere",
                                    .make = scene::make_record<Sky>,
                                    .fields = kSkyFields,
                                    .check = scene::check_record<Sky, with_pigment>};

/// The scene's sky; null if it has none.
const scene::Statement* find_sky(const scene::Database& database) {
  const auto sky = std::ranges::find(database.statements, &kSky, &scene::Statement::kind);
  return sky == database.statements.end() ? nullptr : &*sky;
}

/// The weights by which POV-Ray reduces a colour to one number.
double gray(const Rgb& colour) { return 0.297 * colour.x + 0.589 * colour.y + 0.114 * colour.z; }

class SkyStage final : public Stage<MissWork> {
 public:
  explicit SkyStage(const StageContext& context)
      : statement_(*find_sky(context.database)),
        sky_(statement_.as<Sky>()),
        textures_(context.textures),
        refusals_(context.refusals),
        emission_(rgb(sky_.emission)),
        is_old_(context.database.settings.language_version < 3.7),
        is_moved_(sky_.world_from_sky != scene::kIdentity) {
    if (is_moved_) world_from_sky_ = context.database.transforms[index(sky_.world_from_sky)];
  }

  void run(MissWork& work) const override {
    for (const std::uint32_t i : work.misses) {
      const PathEntry& path = work.batch.entries[i];
      const Vec3& direction = work.batch.rays[i].direction;
      const Vec3 place = is_moved_ ? world_from_sky_.inverse_point(direction) : direction;
      Layers above;
      Rgb colour(0);
      for (auto pigment = sky_.pigments.rbegin(); pigment != sky_.pigments.rend(); ++pigment) {
        const std::optional<scene::Colour> found = textures_.pigment_colour(*pigment, place);
        if (!found) return refusals_.report("this sky_sphere", statement_.origin);
        const scene::Colour& layer = *found;
        const Rgb light = rgb(layer) * emission_ * (1 - layer.filter - layer.transmit);
        colour += is_old_ ? light * above.dimming() : light * above.through;
        above.add(layer);
      }
      const Rgb through = is_old_ ? above.old_through() : above.through;
      work.colours[path.sample] += path.factor * (colour + through * work.background);
      if (!work.alphas.empty())
        work.alphas[path.sample] = 1 - gray(path.factor * through) * (1 - work.background_alpha);
    }
  }

 private:
  /// The light that layers let through together.
  struct Layers {
    Rgb through{1};   ///< Π (c f + t)
    Rgb filtered{1};  ///< Π c f
    double filter = 1, transmit = 1;
    bool is_empty = true;

    void add(const scene::Colour& layer) {
      through *= rgb(layer) * layer.filter + Rgb(layer.transmit);
      filtered *= rgb(layer) * layer.filter;
      filter *= layer.filter;
      transmit *= layer.transmit;
      is_empty = false;
    }
    [[nodiscard]] double dimming() const { return is_empty ? 1 : filter + transmit; }
    [[nodiscard]] Rgb old_through() const { return is_empty ? Rgb(1) : filtered + Rgb(transmit); }
  };

  const scene::Statement& statement_;
  const Sky& sky_;
  const PointTextures& textures_;
  PointRefusals& refusals_;
  Rgb emission_;
  bool is_old_;
  bool is_moved_;
  scene::Transform world_from_sky_;
};

}  // namespace

Effect sky_sphere() {
  return {.name = "sky_sphere",
          .summary = "a sky of pigments instead of the background",
          .statement = &kSky,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "there is no sky_sphere";
                if (const scene::Statement* const sky = find_sky(use.database()))
                  requests.add("`sky_sphere`", sky->origin);
              },
          .stages = {.miss = make_stage<SkyStage, MissWork>}};
}

}  // namespace isl::render
