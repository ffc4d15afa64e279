// Mirror reflection. A surface with the reflectivity R(c) = minimum + (maximum − minimum)(1 − c)^falloff, where c is
// the cosine of the angle between the view and the normal, adds R × the light that a ray mirrored in the surface sees.
// `metallic` tints R by the pigment (shading/metal.h). As in POV-Ray, each layer of a texture reflects by itself,
// however much it lets through, and the layers above it do not filter its reflection.
//
// All layers and textures of a point mirror in the same direction, so their reflectivities add up to one ray.
#include "renderer/effects/effect.h"
#include "renderer/numerics/power.h"
#include "renderer/shading/metal.h"

#include <algorithm>

namespace isl::render {
namespace {

double largest(const Rgb& colour) { return std::max({colour.x, colour.y, colour.z}); }

struct Reflectivity {
  Rgb share{0};
  double bound = 0;  ///< the greatest reflectivity of a layer that POV-Ray assumes, at any angle
};

/// The surface's reflectivity for the path. Layers that adc_bailout ends are left out.
Reflectivity reflectivity(const ShadingPoint& point, double cosine, double weight, double least_weight,
                          EndedPaths& ended) {
  Reflectivity sum;
  for (const LitTexture& texture : point.textures) {
    const scene::Finish& finish = *texture.material->finish;
    if (!reflects(finish)) continue;
    const scene::Reflection& mirror = finish.reflection;
    const Rgb minimum = rgb(mirror.minimum), maximum = rgb(mirror.maximum);
    const double bound = std::max(largest(minimum), largest(maximum)) * largest(texture.let_through);
    if (weight * bound < least_weight) {
      ++ended.by_weight;
      continue;
    }
    Rgb share = minimum;
    if (maximum != minimum) {
      const double grazing = mirror.falloff == 1 ? 1 - cosine : power(1 - cosine, mirror.falloff);
      share += (maximum - minimum) * grazing;
    }
    if (mirror.metallic != 0) share *= metal_tint(mirror.metallic, cosine, texture.colour);
    sum.share += share * texture.weight;
    sum.bound = std::max(sum.bound, bound);
  }
  return sum;
}

class ReflectionStage final : public Stage<SpawnWork> {
 public:
  explicit ReflectionStage(const StageContext& context)
      : least_weight_(context.database.settings.adc_bailout), most_levels_(context.database.settings.max_trace_level) {}

  void run(SpawnWork& work) const override {
    for (std::size_t i = 0; i < work.block.points.size(); ++i) {
      const ShadingPoint& point = work.block.points[i];
      if (std::ranges::none_of(point.textures, [](const LitTexture& lit) { return reflects(*lit.material->finish); }))
        continue;
      const std::uint32_t at = work.block.paths[i];
      const PathEntry& path = work.batch.entries[at];
      if (path.level >= most_levels_) {
        ++work.ended.by_level;
        continue;
      }
      const double cosine = std::clamp(-point.view.dot(point.normal), 0.0, 1.0);
      const Reflectivity mirrored = reflectivity(point, cosine, path.weight, least_weight_, work.ended);
      if (mirrored.share == Rgb(0)) continue;
      push(work, at, point, mirrored);
    }
  }

 private:
  static void push(SpawnWork& work, std::uint32_t at, const ShadingPoint& point, const Reflectivity& reflectivity) {
    const Ray& ray = work.batch.rays[at];
    const Hit& hit = work.batch.hits[at];
    PathEntry child = work.batch.entries[at];
    child.factor *= reflectivity.share;
    child.weight *= reflectivity.bound;
    ++child.level;
    child.kind = RayKind::reflection;
    Ray mirrored;
    mirrored.origin = point.position;
    mirrored.direction = (point.view - point.normal * (2 * point.normal.dot(point.view))).normalized();
    mirrored.path_length = ray.path_length + hit.t;
    mirrored.start = hit.start();
    work.children.push(mirrored, child);
  }

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
          .stages = {.spawn = make_stage<ReflectionStage, SpawnWork>}};
}

}  // namespace isl::render
