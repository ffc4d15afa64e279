// The part of the integrator that lights the points of a block: which of them a light reaches, the light that they
// throw back, and the shadow rays that decide whether it counts.
#include "renderer/integrator/integrator.h"
#include "renderer/shading/area_grid.h"

#include <algorithm>

namespace isl::render {
namespace {

/// Shadow rays after which the queue is traced before the batch's last point, so that a scene of thousands of lights
/// needs no more memory than one of a few: about a megabyte. Every sample still gets its light in the order of the
/// lights.
constexpr std::size_t kLongestShadowQueue = 8192;

bool has_area_illumination(const scene::Light& light) { return light.area && light.area->area_illumination; }

}  // namespace

std::size_t Integrator::face_light(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const {
  const scene::Light& light = placed.light;
  std::size_t count = 0;
  if (!has_strengths() && !back_light_ && memory.block.normals.empty()) {
    for (std::uint32_t i = 0; i < memory.block.points.size(); ++i) {
      const ShadingPoint& point = memory.block.points[i];
      const LightSample sample = sample_light(light, point.position);
      const double incidence = point.normal.dot(sample.direction);
      if (incidence > 0) memory.lit[count++] = {i, sample, incidence, Rgb(0)};
    }
    return count;
  }
  for (std::size_t i = 0; i < memory.block.points.size(); ++i)
    memory.samples[i] = sample_light(light, memory.block.points[i].position);
  return face_samples(batch, placed, memory);
}

std::size_t Integrator::face_samples(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const {
  std::size_t count = 0;
  const std::span<LightSample> samples = std::span(memory.samples).first(memory.block.points.size());
  ReachWork work{batch, memory.block, placed.light, placed.group, samples};
  run(reach_, work);
  if (windows_ && LightWindows::has_window(placed.light) && !throws_soft_shadows(placed.light))
    pass_window(placed.light, memory);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (samples[i].strength == 0 || samples[i].distance == 0) continue;
    if (add_cosines(memory.block, memory.block.points[i], samples[i], memory.cosines))
      memory.lit[count++] = {i, samples[i], 0, Rgb(0)};
  }
  return count;
}

void Integrator::pass_window(const scene::Light& light, PathMemory& memory) const {
  std::vector<Ray> rays(memory.block.points.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i].origin = memory.block.points[i].position;
    rays[i].direction = memory.samples[i].direction;
    rays[i].t_max = memory.samples[i].distance;
  }
  windows_->trim(light, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].t_max < 0) memory.samples[i].strength = 0;
    memory.samples[i].distance = rays[i].t_max;
  }
}

bool Integrator::add_cosines(const SurfaceBlock& block, const ShadingPoint& point, const LightSample& sample,
                             std::vector<double>& cosines) const {
  bool is_lit = false;
  const std::size_t first = cosines.size();
  for (const LitTexture& texture : point.textures) {
    double cosine = block.normal_of(point, texture).dot(sample.direction);
    if (cosine < 0) {
      if (back_light_ && point.is_lit_from_both_sides) {
        cosine = -cosine;
      } else if (!back_light_ || !(texture.material->diffuse_back > 0)) {
        cosine = 0;
      }
    }
    is_lit |= cosine != 0;
    cosines.push_back(cosine);
  }
  if (!is_lit) cosines.resize(first);
  return is_lit;
}

std::span<LitPoint> Integrator::throw_back(const PathBatch& batch, const scene::Light& light, std::size_t count,
                                           PathMemory& memory) const {
  memory.shine.clear();
  const std::span<LitPoint> lit_points = std::span(memory.lit).first(count);
  LightWork work{batch, memory.block, light, lit_points, memory.cosines, memory.shine};
  run(diffuse_, work);
  if (!light.shadowless && !is_around(batch)) run(shine_, work);
  if (!memory.shine.empty() || has_strengths()) {
    auto shine = memory.shine.begin();
    for (LitPoint& lit : lit_points) {
      if (!memory.shine.empty()) {
        for (const LitTexture& texture : memory.block.points[lit.point].textures)
          lit.colour += texture.let_through * (*shine++ * texture.weight);
      }
      if (has_strengths()) lit.colour *= lit.light.strength;
    }
  }
  run(dim_, work);
  return lit_points;
}

std::uint32_t Integrator::points_of(const PathBatch& batch, const PlacedLight& placed, const PathMemory& memory) {
  const scene::AreaLight& area = *placed.light.area;
  const int count = area.count_a * area.count_b;
  if (!placed.scattered || memory.block.paths.empty()) return static_cast<std::uint32_t>(count);
  return memory.pixel_sample(batch.entries[memory.block.paths.front()].sample).share_of(count);
}

void Integrator::aim_at_area(const PathBatch& batch, const PlacedLight& placed, std::span<const LightSample> centres,
                             std::uint32_t number, PathMemory& memory) const {
  const scene::Light& light = placed.light;
  const scene::AreaLight& area = *light.area;
  const auto aim = [&](std::size_t i, const Vec3& offset) {
    memory.samples[i] = sample_light_from(light, light.location + offset, memory.block.points[i].position);
  };
  if (!placed.scattered) {
    const auto rows = static_cast<std::uint32_t>(area.count_b);
    const std::uint32_t column = number / rows, row = number % rows;
    for (std::size_t i = 0; i < centres.size(); ++i)
      aim(i, area_offset(area, edges_of(area, centres[i].direction), column, row));
    return;
  }
  const std::uint32_t share = points_of(batch, placed, memory);
  memory.places.clear();
  for (const std::uint32_t i : memory.block.paths) {
    const PathEntry& path = batch.entries[i];
    memory.places.push_back(
        memory.pixel_sample(path.sample).place(SampleUse::lit_from_area, share, number, path.level, placed.number));
  }
  memory.set_points();
  for (std::size_t i = 0; i < centres.size(); ++i)
    aim(i, placed.scattered->even_offset(edges_of(area, centres[i].direction), memory.points[i]));
}

std::span<LitPoint> Integrator::throw_back_from_area(const PathBatch& batch, const PlacedLight& placed,
                                                     PathMemory& memory) const {
  const scene::Light& light = placed.light;
  const std::size_t count = memory.block.points.size();
  std::array<LightSample, kBlockSize> centres;
  std::array<Rgb, kBlockSize> sums;
  for (std::size_t i = 0; i < count; ++i) {
    centres[i] = sample_light(light, memory.block.points[i].position);
    sums[i] = Rgb(0);
  }
  const std::uint32_t points = points_of(batch, placed, memory);
  for (std::uint32_t number = 0; number < points; ++number) {
    if (is_over()) return {};
    aim_at_area(batch, placed, std::span(centres).first(count), number, memory);
    memory.cosines.clear();
    for (const LitPoint& lit : throw_back(batch, light, face_samples(batch, placed, memory), memory))
      sums[lit.point] += lit.colour;
  }
  const double share = 1.0 / points;
  for (std::uint32_t i = 0; i < count; ++i) memory.lit[i] = {i, centres[i], 0, sums[i] * share};
  return std::span(memory.lit).first(count);
}

void Integrator::light_block(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const {
  const scene::Light& light = placed.light;
  memory.cosines.clear();
  const std::span<LitPoint> lit_points = has_area_illumination(light)
                                             ? throw_back_from_area(batch, placed, memory)
                                             : throw_back(batch, light, face_light(batch, placed, memory), memory);
  const Rgb light_colour = rgb(light.colour);
  const bool is_shadowed = shadows_ && !light.shadowless;
  const bool is_even = light.area && !light.area->jitter && light.area->adaptive == scene::AreaLight::kNotAdaptive;
  if (is_even) memory.area_weights = {area_weights(light.area->count_a), area_weights(light.area->count_b)};
  if (is_shadowed && placed.scattered && !takes_adaptive_grid(placed, batch, memory))
    return push_scattered(batch, placed, lit_points, memory);
  for (const LitPoint& lit : lit_points) {
    const std::uint32_t at = memory.block.paths[lit.point];
    const PathEntry& path = batch.entries[at];
    const Rgb colour = path.factor * (lit.colour * light_colour);
    if (colour == Rgb(0)) continue;
    if (!is_shadowed) {
      memory.colours[path.sample] += colour;
      continue;
    }
    if (!light.area) [[likely]] {
      set_way(batch, lit, memory.block, memory.shadows.add(path, colour));
      continue;
    }
    Ray to_light;
    set_way(batch, lit, memory.block, to_light);
    if (is_even) {
      push_area(light, to_light, path, colour, memory);
    } else {
      // The strengths of the points of a light with `area_illumination` are in the colour already.
      const double strength = has_area_illumination(light) ? 1 : lit.light.strength;
      AreaTarget target{&light, path.sample, {path.bodies, path.contact}, colour, light_colour * strength, to_light};
      if (placed.scattered)
        target.jitter_seed =
            memory.pixel_sample(path.sample).own_seed(SampleUse::light_area, path.level, placed.number);
      if (!memory.area_shadows.push(target)) return refusals_.report("this object", tracer_.origin_of(batch.hits[at]));
      trace_long_queues(memory);
    }
  }
}

void Integrator::set_way(const PathBatch& batch, const LitPoint& lit, const SurfaceBlock& block, Ray& ray) {
  const std::uint32_t at = block.paths[lit.point];
  const Hit& hit = batch.hits[at];
  ray.origin = block.points[lit.point].position;
  ray.direction = lit.light.direction;
  ray.t_max = lit.light.distance;
  ray.path_length = batch.rays[at].path_length + hit.t;
  ray.start = hit.start();
}

bool Integrator::takes_adaptive_grid(const PlacedLight& placed, const PathBatch& batch, const PathMemory& memory) {
  return placed.light.area->adaptive != scene::AreaLight::kNotAdaptive &&
         points_of(batch, placed, memory) == static_cast<std::uint32_t>(placed.scattered->count());
}

void Integrator::set_area_points(const PathBatch& batch, const PlacedLight& placed,
                                 std::span<const LitPoint> lit_points, std::uint32_t share, PathMemory& memory) {
  memory.places.clear();
  for (const LitPoint& lit : lit_points) {
    const PathEntry& path = batch.entries[memory.block.paths[lit.point]];
    const PixelSample& sample = memory.pixel_sample(path.sample);
    for (std::uint32_t i = 0; i < share; ++i)
      memory.places.push_back(sample.place(SampleUse::light_area, share, i, path.level, placed.number));
  }
  memory.set_points();
}

void Integrator::push_ray(const scene::Light& light, const Vec3& source, const Ray& to_light, const PathEntry& path,
                          const Rgb& colour, PathMemory& memory) const {
  const LightSample way = sample_light_from(light, source, to_light.origin);
  Ray ray = to_light;
  ray.direction = way.direction;
  ray.t_max = way.distance;
  if (windows_ && LightWindows::has_window(light)) {
    windows_->trim(light, std::span(&ray, 1));
    if (ray.t_max < 0) return;
  }
  memory.shadows.push(path, ray, colour);
}

void Integrator::push_scattered(const PathBatch& batch, const PlacedLight& placed, std::span<const LitPoint> lit_points,
                                PathMemory& memory) const {
  const Rgb light_colour = rgb(placed.light.colour);
  const std::uint32_t share = points_of(batch, placed, memory);
  // The light of a sample is added up in the order of the queue, which must not depend on the samples beside it: only
  // camera rays have one lit point for each sample.
  const bool may_sort = &batch == &memory.levels.front().batch;
  // Few enough that their points stay in the cache.
  const std::size_t together = std::max(kBlockSize / share, std::size_t{1});
  for (std::size_t first = 0; first < lit_points.size(); first += together) {
    const std::span<const LitPoint> some = lit_points.subspan(first, std::min(together, lit_points.size() - first));
    set_area_points(batch, placed, some, share, memory);
    memory.towards_area.resize(some.size());
    for (std::size_t i = 0; i < some.size(); ++i) {
      TowardsArea& towards = memory.towards_area[i];
      towards.path = &batch.entries[memory.block.paths[some[i].point]];
      towards.colour = towards.path->factor * (some[i].colour * light_colour) / share;
      set_way(batch, some[i], memory.block, towards.middle);
      towards.edges = edges_of(*placed.light.area, towards.middle.direction);
    }
    for (const std::uint32_t i :
         may_sort ? memory.by_place.of(memory.points) : memory.by_place.unsorted(memory.points)) {
      const TowardsArea& towards = memory.towards_area[i / share];
      if (towards.colour == Rgb(0)) continue;
      push_ray(placed.light, placed.light.location + placed.scattered->offset(towards.edges, memory.points[i]),
               towards.middle, *towards.path, towards.colour, memory);
    }
    trace_long_queues(memory);
    if (is_over()) return;
  }
}

void Integrator::push_area(const scene::Light& light, const Ray& to_light, const PathEntry& path, const Rgb& colour,
                           PathMemory& memory) const {
  const scene::AreaLight& area = *light.area;
  const AreaEdges edges = edges_of(area, to_light.direction);
  const auto& [weights_a, weights_b] = memory.area_weights;
  for (int u = 0; u < area.count_a; ++u) {
    for (int v = 0; v < area.count_b; ++v) {
      push_ray(light, light.location + area_offset(area, edges, u, v), to_light, path,
               colour * (weights_a[static_cast<std::size_t>(u)] * weights_b[static_cast<std::size_t>(v)]), memory);
    }
    trace_long_queues(memory);
    if (is_over()) return;
  }
}

void Integrator::trace_long_queues(PathMemory& memory) const {
  if (memory.shadows.size() >= kLongestShadowQueue || memory.around.size() >= kLongestShadowQueue ||
      memory.area_shadows.is_full())
    trace_shadows(memory);
}

void Integrator::resolve(ShadowQueue& queue, std::uint64_t& count, PathMemory& memory) const {
  if (shadow_filter_) {
    queue.resolve(*shadow_filter_, memory.colours, memory.certainties, memory.lists, memory.shadow_filter,
                  memory.counters);
  } else {
    queue.resolve(tracer_, memory.colours, memory.certainties, memory.counters);
  }
  count += queue.size();
  queue.clear();
}

void Integrator::trace_shadows(PathMemory& memory) const {
  resolve(memory.shadows, memory.counts.shadow, memory);
  resolve(memory.around, memory.counts.around, memory);
  if (memory.area_shadows.is_empty()) return;
  const ShadowTracer tracer{tracer_,
                            shadow_filter_ ? &*shadow_filter_ : nullptr,
                            windows_ ? &*windows_ : nullptr,
                            memory.lists,
                            memory.shadow_filter,
                            memory.counters};
  memory.counts.shadow += memory.area_shadows.resolve(tracer, memory.colours, memory.certainties);
}

}  // namespace isl::render
