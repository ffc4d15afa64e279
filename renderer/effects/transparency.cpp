// Surfaces that let light through: behind each, the path goes on, bent by the interiors on both sides (Snell), or is
// reflected within (total reflection). Light that leaves a body has faded along its way through it. The light of
// shadow rays is filtered by paths/shadow_filter.cpp.
//
// A path knows the bodies that it is in; the one that it entered last decides. It leaves a body that it is in, and
// enters any other, whichever way the surface's normal points. Bodies that touch are left and entered one after the
// other (paths/contacts.h).
#include "renderer/effects/effect.h"
#include "renderer/effects/pigment_search.h"
#include "renderer/paths/behind.h"
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/scene/image_transparency.h"
#include "renderer/shading/interiors.h"
#include "renderer/shading/irid.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace isl::render {
namespace {

class TransparencyStage final : public Stage<SpawnWork> {
 public:
  explicit TransparencyStage(const StageContext& context)
      : interiors_(context.database),
        film_(context.database.settings),
        least_weight_(context.database.settings.adc_bailout),
        most_levels_(context.database.settings.max_trace_level) {}

  void run(SpawnWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      std::optional<Behind> found;
      for (std::size_t first = 0; first < point.textures.size();) {
        // Textures that have the same normal send one ray on.
        Rgb passing(0), kept(0);
        bool lets_through = false;
        const Vec3& normal = work.block.normal_of(point, point.textures[first]);
        std::size_t at = first;
        for (; at < point.textures.size(); ++at) {
          const LitTexture& texture = point.textures[at];
          const Rgb through = work.block.passing_of(texture);
          // A layer below the top does not let light through by itself.
          if (through == Rgb(0)) continue;
          if (lets_through && work.block.normal_of(point, texture) != normal) break;
          lets_through = true;
          passing += through * texture.weight;
          kept += kept_within(point, texture, normal) * texture.weight;
        }
        first = std::max(at, first + 1);
        if (!lets_through) continue;
        if (!found) {
          const std::uint32_t path = work.block.paths[i];
          const Body body{point.body, point.interior, point.is_hollow};
          found = behind(interiors_, work.lists.bodies, work.batch.entries[path], body, point.from_inside);
        }
        if (const int colours = found->colours();
            colours > 1 && work.batch.entries[work.block.paths[i]].wave.is_white()) {
          part(work, i, normal, {passing, kept}, *found, colours);
        } else {
          send_on(work, i, normal, {passing, kept}, *found, {});
        }
      }
    }
  }

 private:
  /// The shares of light that a surface lets through, and that it keeps within where it reflects totally.
  struct Shares {
    Rgb passing, kept;
  };

  /// Total reflection takes nothing from the light, but films colour it as they colour all that a surface throws back.
  [[nodiscard]] Rgb kept_within(const ShadingPoint& point, const LitTexture& texture, const Vec3& normal) const {
    const scene::Finish& finish = *texture.material->finish;
    if (finish.irid == 0) return Rgb(1);
    const double cosine = normal.dot(point.view);
    return film_factor(finish, film_, point.position, cosine, cosine);
  }

  /// Light of one of the colours into which a surface parts white light.
  struct Part {
    Wave wave;
    Rgb tint{1};
  };

  void part(SpawnWork& work, std::size_t i, const Vec3& normal, const Shares& shares, const Behind& there,
            int colours) const {
    bool all_are_total = true;
    for (int colour = 0; colour < colours; ++colour) {
      const Wave wave((colour + 0.5) / colours);
      const auto end = [&](int number) { return light_up_to(static_cast<double>(number) / colours); };
      Behind of_wave = there;
      of_wave.ratio = there.ratio_of(wave);
      work.is_total[i] = 0;
      send_on(work, i, normal, shares, of_wave, {wave, end(colour + 1) - end(colour)});
      all_are_total &= work.is_total[i] != 0;
    }
    work.is_total[i] = all_are_total;
  }

  void send_on(SpawnWork& work, std::size_t i, const Vec3& normal, const Shares& shares, const Behind& there,
               const Part& part) const {
    const ShadingPoint& point = work.block.points[i];
    const std::uint32_t at = work.block.paths[i];
    const PathEntry& path = work.batch.entries[at];
    const Hit& hit = work.batch.hits[at];
    if (path.level >= most_levels_) {
      ++work.ended.by_level;
      return;
    }
    const std::optional<Vec3> direction = refracted(point.view, normal, there.ratio);
    // As in POV-Ray, what reflects totally mirrors nothing besides, even if the path ends here.
    if (!direction && largest(shares.passing) >= least_weight_) work.is_total[i] = 1;
    PathEntry child = path;
    child.factor *= part.tint;
    if (!part.wave.is_white()) child.wave = part.wave;
    child.weight *= largest(shares.passing);
    if (child.weight < least_weight_) {
      ++work.ended.by_weight;
      return;
    }
    const Rgb faded = point.from_inside ? interiors_[point.interior].left_after(hit.t) : Rgb(1);
    Ray next;
    next.origin = point.position;
    next.path_length = work.batch.rays[at].path_length + hit.t;
    next.start = hit.start();
    // POV-Ray does not count a segment that goes straight on.
    child.level = static_cast<std::uint16_t>(path.level + (there.ratio == 1 ? 0 : 1));
    if (direction) {
      child.factor *= shares.passing * faded;
      child.bodies = there.bodies;
      child.in_solid = there.in_solid;
      next.direction = *direction;
    } else {
      // As in POV-Ray, the path's weight falls as if the surface let the light through.
      child.factor *= faded * shares.kept;
      child.kind = RayKind::reflection;
      next.direction = mirrored(point.view, normal, point.normal);
    }
    work.send(next, child);
  }

  Interiors interiors_;
  FilmLight film_;
  double least_weight_;
  int most_levels_;
};

bool lets_light_through(const scene::Database& database, const scene::Pigment& pigment,
                        const scene::PatternedPigment* record) {
  if (record) {
    const auto* const image = std::get_if<scene::ImageId>(&record->pattern.operands);
    if (image && info_of(record->pattern.kind).colour && scene::may_be_transparent(database.images[index(*image)]))
      return true;
    const auto* const terms = std::get_if<scene::ColourOperands>(&record->pattern.operands);
    if (terms && scene::may_be_transparent(*terms)) return true;
  }
  if (record && record->pattern.kind != scene::PatternKind::plain) return false;
  const scene::Colour& colour = record ? record->colour : pigment.colour;
  return colour.filter != 0 || colour.transmit != 0;
}

}  // namespace

Effect transparency() {
  return {.name = "transparency",
          .summary = "surfaces that let light through",
          .rays = "refraction",
          .from_quality = 6,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no texture lets light through";
                for (const Use<scene::Texture>& texture : use.textures()) {
                  // A layer above the lowest lets the next one show through, which needs nothing.
                  if (texture.record->below != scene::kNoTexture || texture.record->pattern != scene::kNoTexturePattern)
                    continue;
                  const auto word = find_pigment(use.database(), texture.record->pigment, lets_light_through);
                  if (word) requests.add("a transparent pigment", *word, texture.user);
                }
              },
          .stages = {.spawn = make_stage<TransparencyStage, SpawnWork>, .passing = true}};
}

}  // namespace isl::render
