// Fog. Over a distance s, the share e^(−ρs/distance) of the light from behind gets through, but at least the transmit
// of the fog's colour; the rest is the fog's colour. The colour tints the light that gets through, as far as its filter
// says. Several fogs attenuate one after the other, and their colours add up, as in POV-Ray. There is no fog inside
// objects that are not `hollow`.
//
// ρ is the mean density along the way. Fog of type 1 has the density 1 everywhere; fog of type 2 has it up to the
// height `fog_offset` and 1/(1 + y²) above, where y is the height over that in units of `fog_alt`.
#include "renderer/effects/effect.h"
#include "renderer/numerics/power.h"
#include "renderer/patterns/kinds/turbulence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

struct Fog {
  scene::Colour colour{};
  double distance = 0;  ///< at which fog of density 1 lets 1/e of the light through; 0: no fog
  int type = 1;         ///< 2: it lies on the ground
  double offset = 0;
  double altitude = 0;
  Vec3 up{0, 1, 0};
  scene::Turbulence turbulence;
  double turbulence_depth = 0.5;
};

using scene::field;
using scene::FieldRule;

constexpr scene::StatementField kFogFields[] = {
    field<&Fog::type>("fog_type").within(1, 2),
    field<&Fog::colour>("").with_key("colour").with(FieldRule::bare),
    field<&Fog::distance>("distance").with(FieldRule::bare).within(0, std::numeric_limits<double>::infinity()),
    field<&Fog::turbulence>(""),
    field<&Fog::turbulence_depth>("turb_depth"),
    field<&Fog::offset>("fog_offset"),
    field<&Fog::altitude>("fog_alt"),
    field<&Fog::up>("up").with(FieldRule::turned),
};

constexpr scene::StatementKind kFog{
    .word = "fog", .noun = "a fog", .list = "fogs", .make = scene::make_record<Fog>, .fields = kFogFields};

/// The integral of the density over the heights from 0 to `height`.
double depth_to(double height, double altitude) {
  return height > 0 ? altitude * std::atan(height / altitude) : height;
}

/// The mean density between two heights above the offset. Without an altitude, there is no fog above it.
double mean_density(double from, double to, double altitude) {
  // The difference quotient loses digits where the heights are close. The density at their middle is off by at most
  // (to − from)²/12 altitude² there, as its second derivative is at most 2/altitude².
  if (std::abs(to - from) <= 1e-5 * altitude) {
    const double y = (from + to) / 2 / altitude;
    return from + to > 0 ? 1 / (1 + y * y) : 1;
  }
  return (depth_to(to, altitude) - depth_to(from, altitude)) / (to - from);
}

/// POV-Ray's length of a way that meets nothing.
constexpr double kFar = 2e10;

/// The fogs of a scene.
class Fogs {
 public:
  explicit Fogs(const StageContext& context)
      : noise_(values::noise_generator_of(context.database.settings.noise_generator)) {
    for_each_statement<Fog>(context.database, kFog, [this](const Fog& fog, OriginId) {
      if (fog.distance != 0) fogs_.push_back(fog);
    });
  }

  struct Air {
    Rgb through{1};  ///< the share of the light that comes along
    Rgb added{0};    ///< the light of the fogs themselves
  };
  /// The fogs along a part of a ray.
  [[nodiscard]] Air along(const Ray& ray, double length) const {
    Air air;
    for (const Fog& fog : fogs_) {
      const double share = std::max(exponential(-optical_depth(fog, ray, length)), fog.colour.transmit);
      air.through *= (Rgb(1 - fog.colour.filter) + rgb(fog.colour) * fog.colour.filter) * share;
      air.added += rgb(fog.colour) * (1 - share);
    }
    return air;
  }

 private:
  /// ρs/distance, with the density that turbulence leaves.
  [[nodiscard]] double optical_depth(const Fog& fog, const Ray& ray, double length) const {
    double depth = length / fog.distance;
    if (fog.turbulence.amount != Vec3(0)) {
      const Vec3 middle = (ray.origin + ray.direction * (length / 2)) * fog.turbulence.amount;
      const double gaps = turbulence_at(middle, fog.turbulence, noise_);
      depth *= 1 - exponential(-depth) * std::min(1.0, gaps * fog.turbulence_depth);
    }
    if (fog.type == 1) return depth;
    // A negative altitude turns the fog upside down.
    const auto height = [&](double t) {
      return std::copysign(1, fog.altitude) * ((ray.origin + ray.direction * t).dot(fog.up) - fog.offset);
    };
    return depth * mean_density(height(0), height(length), std::abs(fog.altitude));
  }

  std::vector<Fog> fogs_;
  values::NoiseGenerator noise_;
};

class FogStage final : public Stage<AlongWork> {
 public:
  explicit FogStage(const StageContext& context) : fogs_(context) {}

  void run(AlongWork& work) const override {
    for (std::size_t i = 0; i < work.batch.size(); ++i) {
      PathEntry& path = work.batch.entries[i];
      if (path.in_solid) continue;
      const Fogs::Air air = fogs_.along(work.batch.rays[i], std::min(work.batch.hits[i].t, kFar));
      work.colours[path.sample] += path.factor * air.added;
      path.factor *= air.through;
    }
  }

 private:
  Fogs fogs_;
};

/// Fog dims the lights that say `media_attenuation`.
class FogOnLightStage final : public Stage<LightWork> {
 public:
  explicit FogOnLightStage(const StageContext& context) : fogs_(context) {}

  void run(LightWork& work) const override {
    if (!work.light.media_attenuation || !work.light.media_interaction) return;
    for (LitPoint& lit : work.lit) {
      if (work.batch.entries[work.block.paths[lit.point]].in_solid) continue;
      Ray to_light;
      to_light.origin = work.block.points[lit.point].position;
      to_light.direction = lit.light.direction;
      lit.colour *= fogs_.along(to_light, std::min(lit.light.distance, kFar)).through;
    }
  }

 private:
  Fogs fogs_;
};

}  // namespace

Effect fog() {
  return {.name = "fog",
          .summary = "fog",
          .from_quality = 9,
          .statement = &kFog,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "there is no fog";
                for_each_statement<Fog>(use.database(), kFog, [&](const Fog& fog, OriginId origin) {
                  if (fog.distance != 0) requests.add("`fog`", origin);
                });
              },
          .stages = {.along = make_stage<FogStage, AlongWork>, .dim = make_stage<FogOnLightStage, LightWork>}};
}

}  // namespace isl::render
