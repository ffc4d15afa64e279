// Mirror reflection. A surface of the reflectivity R (shading/mirror.h) adds R × the light that a ray mirrored in the
// surface sees. As in POV-Ray, each layer of a texture reflects by itself, however much it lets through, and the layers
// above it do not filter its reflection.
//
// Layers and textures of a point that have the same normal mirror in the same direction, so their reflectivities add up
// to one ray, if they have no `exponent` that bends the light each in its own way.
#include "renderer/effects/effect.h"
#include "renderer/shading/interiors.h"
#include "renderer/shading/irid.h"
#include "renderer/shading/mirror.h"

#include <algorithm>
#include <span>

namespace isl::render {
namespace {

struct Reflectivity {
  Rgb share{0};
  double weight = 0;  ///< the factor of a path's weight: the greatest of any layer's
};

/// The reflectivity by which POV-Ray weighs a mirrored path: with Fresnel's formula the one at this angle, else the
/// greatest at any angle.
double weighed(const scene::Finish& finish, const Rgb& share) {
  return finish.fresnel_reflection ? largest(share) : largest_reflectivity(finish);
}

/// The cosines between a surface's normal and the ways from the eye and on. They differ where a mirror image would lie
/// behind the surface (mirrored).
struct MirrorCosines {
  double in, out;
};

/// The reflectivity of some of a point's textures for the path. Layers that adc_bailout ends are left out.
Reflectivity reflectivity(const SurfaceBlock& block, const ShadingPoint& point, std::span<const LitTexture> textures,
                          const FilmLight& film, const MirrorCosines& cosines, double weight, double least_weight,
                          EndedPaths& ended) {
  Reflectivity sum;
  for (const LitTexture& texture : textures) {
    const scene::Finish& finish = *texture.material->finish;
    if (!reflects(finish)) continue;
    Rgb share = reflectivity_at(finish, cosines.in, point.ior_ratio, texture.colour);
    const double factor = weighed(finish, share) * largest(texture.let_through);
    if (weight * factor < least_weight) {
      ++ended.by_weight;
      continue;
    }
    if (finish.irid != 0) share *= film_factor(finish, film, point.position, cosines.out, cosines.in);
    sum.share += share * (texture.weight * block.surface_share_of(texture));
    sum.weight = std::max(sum.weight, factor);
  }
  return sum;
}

double exponent_of(const LitTexture& texture) { return texture.material->finish->reflection.exponent; }

class ReflectionStage final : public Stage<SpawnWork> {
 public:
  explicit ReflectionStage(const StageContext& context)
      : film_(context.database.settings),
        least_weight_(context.database.settings.adc_bailout),
        most_levels_(context.database.settings.max_trace_level) {}

  void run(SpawnWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      if (work.is_total[i] != 0) continue;
      if (std::ranges::none_of(point.textures, [](const LitTexture& lit) { return reflects(*lit.material->finish); }))
        continue;
      const std::uint32_t at = work.block.paths[i];
      const PathEntry& path = work.batch.entries[at];
      if (path.level >= most_levels_) {
        ++work.ended.by_level;
        continue;
      }
      for (std::size_t first = 0; first < point.textures.size();) {
        const std::size_t last = mirroring_alike(work.block, point, first);
        mirror(work, at, point, point.textures.subspan(first, last - first));
        first = last;
      }
    }
  }

 private:
  /// The textures from `first` up to here send one ray on.
  static std::size_t mirroring_alike(const SurfaceBlock& block, const ShadingPoint& point, std::size_t first) {
    const Vec3& normal = block.normal_of(point, point.textures[first]);
    const double exponent = exponent_of(point.textures[first]);
    std::size_t last = first + 1;
    while (last < point.textures.size() && block.normal_of(point, point.textures[last]) == normal &&
           exponent_of(point.textures[last]) == exponent) {
      ++last;
    }
    return last;
  }

  void mirror(SpawnWork& work, std::uint32_t at, const ShadingPoint& point,
              std::span<const LitTexture> textures) const {
    const Vec3& normal = work.block.normal_of(point, textures.front());
    const Vec3 direction = mirrored(point.view, normal, point.normal);
    const MirrorCosines cosines{-point.view.dot(normal), direction.dot(normal)};
    const Reflectivity sum = reflectivity(work.block, point, textures, film_, cosines, work.batch.entries[at].weight,
                                          least_weight_, work.ended);
    if (sum.share != Rgb(0)) push(work, at, point, direction, sum, exponent_of(textures.front()));
  }

  static void push(SpawnWork& work, std::uint32_t at, const ShadingPoint& point, const Vec3& direction,
                   const Reflectivity& reflectivity, double exponent) {
    const Ray& ray = work.batch.rays[at];
    const Hit& hit = work.batch.hits[at];
    PathEntry child = work.batch.entries[at];
    child.factor *= reflectivity.share;
    if (exponent != 1) {
      child.sample = work.bent.add(child.sample, child.factor, 1 / exponent);
      child.factor = Rgb(1);
    }
    child.weight *= reflectivity.weight;
    ++child.level;
    child.kind = RayKind::reflection;
    Ray reflected;
    reflected.origin = point.position;
    reflected.direction = direction;
    reflected.path_length = ray.path_length + hit.t;
    reflected.start = hit.start();
    work.send(reflected, child);
  }

  FilmLight film_;
  double least_weight_;
  int most_levels_;
};

}  // namespace

Effect reflection() {
  return {.name = "reflection",
          .summary = "surfaces that mirror their surroundings",
          .rays = "reflection",
          .from_quality = 8,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no finish reflects";
                for (const Use<scene::Finish>& finish : use.finishes()) {
                  if (reflects(*finish.record))
                    requests.add("`reflection`", finish.record->said_at[scene::FinishItem::reflection], finish.user);
                }
              },
          .stages = {.spawn = make_stage<ReflectionStage, SpawnWork>, .mirrors = true}};
}

}  // namespace isl::render
