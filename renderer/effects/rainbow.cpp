// Rainbows: bands of colour around the direction `direction` in front of whatever is seen. The band's colour at a ray
// is found in the map by the angle between the ray and the direction: the band is `width` wide about `angle`. Around
// the direction, the bow is full up to half of `falloff_angle` from `up`, and fades out to half of `arc_angle`. Of
// several rainbows that a ray meets, the mean is seen, as in POV-Ray.
#include "renderer/effects/effect.h"
#include "renderer/numerics/chance.h"
#include "renderer/numerics/power.h"
#include "renderer/patterns/kinds/pigment_colour.h"
#include "renderer/patterns/map_interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

/// POV-Ray's manual says "by default a sufficiently large value": farther than anything it draws.
constexpr double kFarRainbow = 1e7;

constexpr double kFullCircle = 2 * std::numbers::pi;

/// Angles in radians.
struct Rainbow {
  Vec3 direction{0};  ///< of the light
  Vec3 up{0, 1, 0};   ///< at a right angle to the direction
  double angle = 0, width = 0;
  double distance = kFarRainbow;
  double jitter = 0;  ///< the greatest random step in the map
  double arc_angle = kFullCircle;
  double falloff_angle = kFullCircle;                  ///< at which the arc begins to fade; a full circle: it does not
  scene::PigmentMapId colours = scene::kNoPigmentMap;  ///< from the innermost ring to the outermost
};

constexpr scene::StatementField kRainbowFields[] = {
    scene::field<&Rainbow::direction>("direction"),
    scene::field<&Rainbow::up>("up"),
    scene::field<&Rainbow::angle>("angle").with(scene::FieldRule::degrees),
    scene::field<&Rainbow::width>("width").with(scene::FieldRule::degrees),
    scene::field<&Rainbow::distance>("distance"),
    scene::field<&Rainbow::jitter>("jitter"),
    scene::field<&Rainbow::arc_angle>("arc_angle").with(scene::FieldRule::degrees).within(0, 360),
    scene::field<&Rainbow::falloff_angle>("falloff_angle").with(scene::FieldRule::degrees).within(0, 360),
    scene::field<&Rainbow::colours>("color_map").with_key("colours"),
};

/// Checks POV-Ray's conditions, and makes `up` perpendicular to the direction.
std::string completed(Rainbow& rainbow) {
  if (rainbow.direction.length() == 0) return "a `rainbow` needs a `direction` that is not zero";
  rainbow.direction.normalize();
  const Vec3 up = rainbow.up - rainbow.direction * rainbow.up.dot(rainbow.direction);
  // Parallel within rounding: a cosine of one.
  if (up.length() <= 1e-7 * rainbow.up.length()) return "`up` and `direction` of a `rainbow` are parallel";
  rainbow.up = up.normalized();
  const bool is_fading = rainbow.falloff_angle != kFullCircle;
  if (is_fading && rainbow.falloff_angle > rainbow.arc_angle) return "`falloff_angle` must be at most `arc_angle`";
  return {};
}

constexpr scene::StatementKind kRainbow{.word = "rainbow",
                                        .noun = "a rainbow",
                                        .list = "rainbows",
                                        .make = scene::make_record<Rainbow>,
                                        .fields = kRainbowFields,
                                        .check = scene::check_record<Rainbow, completed>};

bool is_seen(const Rainbow& rainbow) { return rainbow.colours != scene::kNoPigmentMap && rainbow.width != 0; }

/// The light that passes a rainbow, and the light that it adds.
struct Veil {
  Rgb through, added;
};

class RainbowStage final : public Stage<AlongWork> {
 public:
  explicit RainbowStage(const StageContext& context) : database_(context.database) {
    for_each_statement<Rainbow>(context.database, kRainbow, [this](const Rainbow& rainbow, OriginId) {
      if (is_seen(rainbow)) rainbows_.push_back(rainbow);
    });
  }

  void run(AlongWork& work) const override {
    for (std::size_t i = 0; i < work.batch.size(); ++i) {
      PathEntry& path = work.batch.entries[i];
      if (path.in_solid) continue;
      Veil sum{Rgb(0), Rgb(0)};
      int count = 0;
      for (const Rainbow& rainbow : rainbows_) {
        if (add(rainbow, work.batch.rays[i].direction, work.batch.hits[i].t, sum)) ++count;
      }
      if (count == 0) continue;
      work.colours[path.sample] += path.factor * (sum.added / count);
      path.factor *= sum.through / count;
    }
  }

 private:
  /// Adds the veil of one rainbow; false if the ray passes beside its band.
  bool add(const Rainbow& rainbow, const Vec3& view, double length, Veil& sum) const {
    const double angle = std::acos(std::clamp(view.dot(rainbow.direction), -1.0, 1.0));
    double place = (angle - rainbow.angle) / rainbow.width + 0.5;
    if (rainbow.jitter != 0) place += rainbow.jitter * (2 * chance_at(view.x, view.y, view.z) - 1);
    if (!(place >= 0 && place <= 1)) return false;
    const double below = transparency(rainbow, view);
    if (below < 0) return false;
    const scene::Colour colour = colour_at(rainbow, place);
    const double reach = exponential(-length / rainbow.distance);
    const double least = below * (1 - colour.transmit) + colour.transmit;
    const double share = std::max(reach, least), filter = colour.filter * (1 - share);
    sum.through += (Rgb(1 - filter) + rgb(colour) * filter) * share;
    sum.added += rgb(colour) * (1 - share);
    return true;
  }

  /// How transparent the bow is at its place around the direction: from 0 to 1; below 0 if there is no bow.
  static double transparency(const Rainbow& rainbow, const Vec3& view) {
    const double half_arc = rainbow.arc_angle / 2, half_full = std::min(rainbow.falloff_angle / 2, half_arc);
    if (half_full >= std::numbers::pi) return 0;
    const Vec3 around = view - rainbow.direction * view.dot(rainbow.direction);
    const double length = around.length();
    const double off = length > 0 ? std::acos(std::clamp(around.dot(rainbow.up) / length, -1.0, 1.0)) : 0;
    if (off > half_arc) return -1;
    if (off <= half_full) return 0;
    const double x = (off - half_full) / (half_arc - half_full);
    return x * x * (3 - 2 * x);
  }

  [[nodiscard]] scene::Colour colour_at(const Rainbow& rainbow, double place) const {
    const auto interval = find_in(database_.pigment_maps[index(rainbow.colours)], place);
    const scene::Colour second = database_.colour(interval.second->pigment);
    if (interval.first == interval.second) return second;
    return blend(database_.colour(interval.first->pigment), second, interval.fraction);
  }

  const scene::Database& database_;
  std::vector<Rainbow> rainbows_;
};

}  // namespace

Effect rainbow() {
  return {.name = "rainbow",
          .summary = "rainbows",
          .from_quality = 9,
          .statement = &kRainbow,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "there is no rainbow";
                for_each_statement<Rainbow>(use.database(), kRainbow, [&](const Rainbow& rainbow, OriginId origin) {
                  if (is_seen(rainbow)) requests.add("`rainbow`", origin);
                });
              },
          .stages = {.along = make_stage<RainbowStage, AlongWork>}};
}

}  // namespace isl::render
