#include "renderer/integrator/integrator.h"

#include "renderer/integrator/camera_place.h"
#include "renderer/paths/behind.h"

#include <algorithm>

namespace isl::render {
namespace {

/// Levels of a path. max_trace_level ends a path before, unless it goes straight on through more surfaces than these:
/// POV-Ray does not count such segments.
constexpr std::size_t kMostLevels = 512;

/// The weights by which POV-Ray reduces a colour to one number.
double gray(const Rgb& colour) { return 0.297 * colour.x + 0.589 * colour.y + 0.114 * colour.z; }

bool is_replaced(const Effect& effect, const Plan& plan) {
  return std::ranges::any_of(plan.called_for,
                             [&](const PlannedEffect& other) { return other.effect->replaces == effect.name; });
}

template <class Work>
void add(MakeStage<Work> make, const StageContext& context, std::vector<std::unique_ptr<const Stage<Work>>>& stages) {
  if (make) stages.push_back(make(context));
}

}  // namespace

Integrator::Integrator(const scene::Database& database, const Tracer& tracer, const Plan& plan,
                       bool transparent_background, const RunLimits& run, const ImageTable* images)
    : database_(database),
      tracer_(tracer),
      run_(run),
      refusals_(run),
      lights_(placed_lights(database, tracer)),
      textures_(database, run, images),
      soft_(plan.is_soft()) {
  const StageContext context{database, tracer, textures_, refusals_};
  bool is_lit_by_sky = false;
  for (const PlannedEffect& planned : plan.called_for) {
    if (is_replaced(*planned.effect, plan)) continue;
    const StageMakers& make = planned.effect->stages;
    add(make.along, context, along_);
    add(make.miss, context, miss_);
    add(make.textures, context, texture_stages_);
    add(make.own_light, context, own_light_);
    add(make.reach, context, reach_);
    add(make.diffuse, context, diffuse_);
    add(make.shine, context, shine_);
    add(make.dim, context, dim_);
    add(make.around, context, around_);
    add(make.spawn, context, spawn_);
    is_lit_by_sky |= make.sky;
    shadows_ |= make.shadows;
    if (make.windows) make_windows();
    back_light_ |= make.back_light;
    bumps_ |= make.bumps;
    passing_ |= make.passing;
    opacities_ |= make.opacities;
    mirrors_ |= make.mirrors;
    if (make.fresnel) interiors_.emplace(database);
  }
  if (passing_) shadow_filter_.emplace(database, tracer, textures_, refusals_, bumps_);
  StepCounter steps(run.steps_at_point, run.stop);
  if (!along_.empty()) camera_in_solid_ = is_camera_in_solid(database, steps);
  if (passing_) camera_bodies_ = bodies_around_camera(database, tracer, steps);
  if (steps.is_spent()) refusals_.report_camera();
  const scene::Colour& background = database.settings.background;
  if (transparent_background) {
    background_alpha_ = 0;
  } else {
    background_ = rgb(background) * (1 - background.transmit);
  }
  // A transparent background lights the scene all the same.
  if (is_lit_by_sky) sky_.emplace(miss_, rgb(background) * (1 - background.transmit));
}

void Integrator::make_windows() {
  std::optional<scene::Refusal> refusal;
  windows_.emplace(database_, run_, refusal);
  if (refusal) refusals_.report(*refusal);
}

bool Integrator::trace(PathMemory& memory, SurfaceObserver* observer) const {
  if (memory.counts.camera == 0) {
    memory.texture_bytes = Charge(run_.budget);
    memory.queue_bytes = Charge(run_.budget);
    memory.shadow_filter.texture_bytes = Charge(run_.budget);
    memory.area_shadows.charge_to(Charge(run_.budget));
  }
  PathBatch& batch = memory.levels.front().batch;
  // Only what lies along rays, and contacts change the entries of the camera's, which are alike in all batches.
  if (!along_.empty() || !memory.lists.contacts.is_empty()) batch.entries.clear();
  memory.lists.clear();
  std::uint32_t camera_bodies = 0;
  for (const Body& body : camera_bodies_) camera_bodies = memory.lists.bodies.entered(camera_bodies, body);
  memory.bent.start(memory.camera_rays().size());
  for (std::size_t i = batch.entries.size(); i < batch.rays.size(); ++i)
    batch.entries.push_back(
        {.sample = static_cast<std::uint32_t>(i), .bodies = camera_bodies, .in_solid = camera_in_solid_});
  batch.entries.resize(batch.rays.size());
  memory.colours.assign(batch.size(), Rgb(0));
  memory.alphas.assign(batch.size(), 1);
  memory.certainties.assign(batch.size(), Certainty::certified);
  memory.counts.camera += batch.size();
  run_level(0, memory, observer);
  return !is_over();
}

void Integrator::run_level(std::size_t level, PathMemory& memory, SurfaceObserver* observer) const {
  PathBatch& batch = memory.levels[level].batch;
  find_hits(batch, memory);
  tell_apart(level, memory);
  // Light from surfaces around comes through clear air, and from nowhere else.
  const bool is_surface_light = is_around(batch);
  if (!along_.empty() && !is_surface_light) {
    AlongWork work{batch, memory.colours};
    run(along_, work);
  }
  if (is_over()) return give_up(level, memory);
  if (!is_surface_light) see_background(level, batch, memory);
  const std::size_t samples = memory.bent.sample_count();
  shade_surfaces(level, memory, observer);
  trace_shadows(memory);
  if (is_over()) return give_up(level, memory);
  trace_children(level, memory);
  if (memory.bent.sample_count() == samples) return;
  memory.bent.finish_from(samples, memory.colours, memory.certainties);
  resize_samples(memory);
}

void Integrator::find_hits(PathBatch& batch, PathMemory& memory) const {
  batch.hits.assign(batch.size(), Hit{});
  if (batch.size() == 0) return;
  const RayKind kind = batch.entries.front().kind;
  if (!passing_) return tracer_.first_hits(batch.rays, batch.hits, memory.counters, kind);
  memory.coinciding.clear();
  tracer_.first_hits(batch.rays, batch.hits, memory.counters, kind, &memory.coinciding);
  PathLists& lists = memory.lists;
  if (!lists.contacts.is_empty()) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (batch.entries[i].contact != 0) batch.hits[i] = lists.contacts.hit_at(batch.entries[i].contact);
    }
  }
  for (std::span<const CoincidingHit> left = memory.coinciding; !left.empty();) {
    const std::span<const CoincidingHit> hits = of_one_ray(left);
    left = left.subspan(hits.size());
    const auto i = static_cast<std::size_t>(hits.front().ray - batch.rays.data());
    PathEntry& path = batch.entries[i];
    if (path.contact != 0) continue;
    const std::vector<CrossedFace> faces = in_order(hits, tracer_, lists.bodies, path.bodies, memory.counters);
    const Certainty certainty = batch.hits[i].certainty;
    batch.hits[i] = faces.front().hit;
    batch.hits[i].certainty = certainty;
    if (faces.size() > 1) path.contact = lists.contacts.add(faces);
  }
}

void Integrator::tell_apart(std::size_t level, PathMemory& memory) {
  PathMemory::Level& at = memory.levels[level];
  const std::size_t count = at.batch.size();
  at.met.resize(count);
  at.misses.resize(count);
  std::uint32_t* const met = at.met.data();
  std::uint32_t* const misses = at.misses.data();
  std::size_t met_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Hit& hit = at.batch.hits[i];
    if (hit.certainty != Certainty::certified) lower(memory.certainties[at.batch.entries[i].sample], hit.certainty);
    met[met_count] = misses[i - met_count] = static_cast<std::uint32_t>(i);
    met_count += hit.is_miss() ? 0 : 1;
  }
  at.met.resize(met_count);
  at.misses.resize(count - met_count);
}

void Integrator::resize_samples(PathMemory& memory) {
  const std::size_t count = memory.bent.sample_count();
  memory.colours.resize(count, Rgb(0));
  memory.alphas.resize(count, 1);
  memory.certainties.resize(count, Certainty::certified);
}

void Integrator::give_up(std::size_t level, PathMemory& memory) {
  memory.levels[level].children.clear();
  memory.shadows.clear();
  memory.around.clear();
  memory.area_shadows.clear();
}

void Integrator::see_background(std::size_t level, const PathBatch& batch, PathMemory& memory) const {
  const std::vector<std::uint32_t>& misses = memory.levels[level].misses;
  if (!miss_.empty()) {
    MissWork work{batch,          misses,
                  background_,    background_alpha_,
                  memory.colours, level == 0 ? std::span<double>(memory.alphas) : std::span<double>()};
    return run(miss_, work);
  }
  for (const std::uint32_t i : misses) {
    const PathEntry& path = batch.entries[i];
    memory.colours[path.sample] += path.factor * background_;
    // The share of a transparent background that media or surfaces hide is opaque; mirrors hide all of it.
    if (background_alpha_ != 0) continue;
    double& alpha = memory.alphas[path.sample];
    if (level == 0) {
      alpha = along_.empty() ? 0 : 1 - gray(path.factor);
    } else if (path.kind == RayKind::image) {
      alpha = std::max(0.0, alpha - gray(path.factor));
    }
  }
}

void Integrator::shade_surfaces(std::size_t level, PathMemory& memory, SurfaceObserver* observer) const {
  PathMemory::Level& at = memory.levels[level];
  at.children.clear();
  memory.block.clear();
  for (std::size_t first = 0; first < at.met.size(); first += kBlockSize) {
    const std::size_t last = std::min(at.met.size(), first + kBlockSize);
    memory.block.paths.assign(at.met.begin() + static_cast<std::ptrdiff_t>(first),
                              at.met.begin() + static_cast<std::ptrdiff_t>(last));
    fill_block(at.batch, memory, observer);
    if (is_over()) return;
    shade_block(level, memory);
    memory.block.clear();
  }
}

void Integrator::fill_block(const PathBatch& batch, PathMemory& memory, SurfaceObserver* observer) const {
  memory.textures.clear();
  const LitTexture* const at_first = memory.textures.data();
  LayerLists lists{.normals = bumps_ ? &memory.block.normals : nullptr,
                   .passing = passing_ ? &memory.block.passing : nullptr,
                   .opacities = opacities_ ? &memory.block.opacities : nullptr,
                   .mirrors = mirrors_};
  const std::vector<std::uint32_t>& paths = memory.block.paths;
  tracer_.set_blob_fields(batch.rays, batch.hits, paths, memory.blob_fields, memory.counters);
  for (std::size_t number = 0; number < paths.size(); ++number) {
    const std::uint32_t i = paths[number];
    const Ray& ray = batch.rays[i];
    SurfacePoint& surface = memory.surface;
    tracer_.surface_at(ray, batch.hits[i], memory.blob_fields[number], surface, memory.counters);
    if (surface.is_refuted) lower(memory.certainties[batch.entries[i].sample], Certainty::refuted);
    const std::size_t first = memory.textures.size();
    lists.normal = turned_to_viewer(surface.normal, ray.direction);
    lists.view = ray.direction;
    const Body body{surface.body, surface.interior, surface.is_hollow};
    // As in POV-Ray, a path enters a body that it meets first, from whichever side; normals have no say.
    const bool from_inside = memory.lists.bodies.holds(batch.entries[i].bodies, body.id);
    if (interiors_)
      lists.ior_ratio = behind(*interiors_, memory.lists.bodies, batch.entries[i], body, from_inside).ratio;
    if (!textures_.append(surface, memory.textures, memory.texture_bytes, lists))
      return refusals_.report("this object", tracer_.origin_of(batch.hits[i]));
    const ShadingPoint& point = memory.block.points.emplace_back(
        surface.position, lists.normal, ray.direction, std::span(memory.textures).subspan(first),
        surface.is_lit_from_both_sides, from_inside, surface.is_hollow, lists.ior_ratio, surface.interior,
        surface.body);
    if (observer) observer->see(i, batch.hits[i], surface, point);
  }
  memory.block.textures = memory.textures.data();
  if (memory.textures.data() == at_first) return;
  // The textures have moved as their list grew.
  const LitTexture* begin = memory.textures.data();
  for (ShadingPoint& point : memory.block.points) {
    point.textures = {begin, point.textures.size()};
    begin += point.textures.size();
  }
}

void Integrator::shade_block(std::size_t level, PathMemory& memory) const {
  PathMemory::Level& at = memory.levels[level];
  TextureWork textures{memory.block, memory.textures};
  run(texture_stages_, textures);
  SurfaceWork own{at.batch, memory.block, memory.colours};
  run(own_light_, own);
  if (!diffuse_.empty() || !shine_.empty()) {
    for (const PlacedLight& light : lights_) {
      if (is_over()) return;
      light_block(at.batch, light, memory);
      trace_long_queues(memory);
    }
  }
  light_from_around(at.batch, memory);
  if (spawn_.empty() || is_around(at.batch)) return;
  memory.is_total.assign(memory.block.points.size(), 0);
  SpawnWork work{at.batch,
                 memory.block,
                 at.children,
                 memory.lists,
                 tracer_,
                 memory.is_total,
                 memory.counts.ended,
                 memory.bent,
                 {memory.pixel_samples, memory.bent}};
  memory.counts.spawned.resize(spawn_.size());
  for (std::size_t i = 0; i < spawn_.size(); ++i) {
    const std::size_t before = at.children.size();
    spawn_[i]->run(work);
    memory.counts.spawned[i] += at.children.size() - before;
  }
  charge_children(level, memory);
  if (memory.bent.sample_count() != memory.colours.size()) resize_samples(memory);
}

void Integrator::light_from_around(const PathBatch& batch, PathMemory& memory) const {
  if (around_.empty()) return;
  AroundWork work{.batch = batch,
                  .block = memory.block,
                  .sample_of = {memory.pixel_samples, memory.bent},
                  .sky = sky_ ? &*sky_ : nullptr,
                  .rays = memory.around,
                  .directions = memory.directions,
                  .colours = memory.direction_colours,
                  .light = memory.direction_light,
                  .scratch = memory.direction_batch};
  do {
    work.is_last = true;
    run(around_, work);
    trace_long_queues(memory);
    ++work.turn;
  } while (!work.is_last && !is_over());
}

void Integrator::charge_children(std::size_t level, PathMemory& memory) const {
  PathMemory::Level& at = memory.levels[level];
  // A list grows to twice its size.
  constexpr std::size_t kSegment = 2 * (sizeof(Ray) + sizeof(PathEntry) + 2 * sizeof(Body));
  constexpr std::size_t kSample = 2 * (3 * sizeof(Rgb) + 2 * sizeof(double) + sizeof(Certainty));
  const auto more = [](std::size_t count, std::size_t counted) { return count > counted ? count - counted : 0; };
  const std::size_t segments = more(at.children.size(), at.children_counted);
  const std::size_t samples = more(memory.bent.sample_count(), memory.samples_counted);
  if (segments + samples == 0) return;
  if (memory.queue_bytes.grow(segments * kSegment + samples * kSample)) {
    at.children_counted += segments;
    memory.samples_counted += samples;
  } else {
    refusals_.report("this object", tracer_.origin_of(at.batch.hits[memory.block.paths.back()]));
  }
}

void Integrator::trace_children(std::size_t level, PathMemory& memory) const {
  if (memory.levels[level].children.size() == 0) return;
  if (level + 1 == kMostLevels) {
    memory.counts.ended.by_level += memory.levels[level].children.size();
    return memory.levels[level].children.clear();
  }
  if (memory.levels.size() <= level + 1) memory.levels.emplace_back();
  PathBatch& next = memory.levels[level + 1].batch;
  memory.levels[level].children.for_each([&](const PathBatch& children) {
    for (std::size_t first = 0; first < children.size(); first += kBatchSize) {
      const std::size_t last = std::min(children.size(), first + kBatchSize);
      next.clear();
      if (is_over()) return;
      for (std::size_t i = first; i < last; ++i) next.push(children.rays[i], children.entries[i]);
      run_level(level + 1, memory, nullptr);
    }
  });
}

}  // namespace isl::render
