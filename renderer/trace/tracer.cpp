#include "renderer/trace/tracer.h"

#include "base/check.h"
#include "renderer/boxes/box_test.h"
#include "renderer/compiled/compiled_scene.h"
#include "renderer/compiled/grid_json.h"
#include "renderer/solids/solid.h"
#include "renderer/trace/cutaway.h"
#include "renderer/trace/face.h"
#include "renderer/trace/rival_module.h"
#include "renderer/trace/surface_check.h"
#include "renderer/trace/trace_entry_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace isl::render {
namespace {

TraceMemory& thread_memory() {
  static thread_local TraceMemory memory;
  return memory;
}

BlobPoint& thread_blob_point() {
  static thread_local BlobPoint point;
  return point;
}

}  // namespace

struct Tracer::Impl {
  CompiledScene scene;
  SolverSettings settings;
  const TraceEntryPoints* entry_points = nullptr;
  const TraceLoops* loops = nullptr;     ///< the loops of entry_points, or a baseline's
  bool some_are_told_by_fields = false;  ///< of the instances
  std::size_t rays_between_looks = 0;    ///< at the flag; a multiple of the rays in a packet

  /// Calls trace(settings, first, count) for all rays, in parts between which the flag is looked at. The published
  /// solver keeps records of a whole batch, which therefore is not divided.
  template <class Trace>
  void in_parts(std::uint64_t ray_steps, std::size_t rays, const Trace& trace) const {
    SolverSettings bounded = settings;
    bounded.ray_steps = ray_steps;
    if (settings.stop == nullptr || is_published(settings.name)) return trace(bounded, 0, rays);
    for (std::size_t first = 0; first < rays && !settings.stop->is_set(); first += rays_between_looks)
      trace(bounded, first, std::min(rays_between_looks, rays - first));
  }

  /// True if it is certain that the surface is not where it was found.
  [[nodiscard]] bool is_wrong(const CompiledBlob& blob, const TextureFrame& own, const Ray& ray, const Hit& hit,
                              const Vec3& local, const BlobFields& fields) const {
    return is_refuted(blob, {local, own.enter_vector(step(ray, hit)), hit.cell}, fields,
                      RaySteps(settings.ray_steps, settings.stop));
  }

  /// How far a hit may be off along its ray: by the tolerance and by the rounding of its coordinates, 2⁻⁴⁸ of them with
  /// room to spare.
  [[nodiscard]] Vec3 step(const Ray& ray, const Hit& hit) const {
    const Vec3& o = ray.origin;
    const double coordinates = std::abs(o.x) + std::abs(o.y) + std::abs(o.z) + std::abs(hit.t);
    return ray.direction * (settings.at(ray.path_length + hit.t) + 0x1p-48 * coordinates);
  }

  /// Sets Instance::is_told_by_fields.
  void find_told_by_fields() {
    for (Instance& instance : scene.instances) {
      if (instance.kind != scene::Object::Kind::blob || instance.interior_texture.id != scene::kNoTexture) continue;
      const CompiledBlob& blob = scene.blobs[instance.shape];
      if (!blob.is_one_sum() || blob.components.size() == 0) continue;
      const ShareRule rule{&scene.coordinate_textures, instance.texture.id};
      instance.is_told_by_fields = rule.may_share(blob.components.texture.front());
      some_are_told_by_fields |= instance.is_told_by_fields;
    }
  }

  /// The normal of an instance that is_told_by_fields, of any length.
  Vec3 shape_of_fields(const Instance& instance, const TextureFrame& own, const Ray& ray, const Hit& hit,
                       const Vec3& local, const BlobFields& fields, SurfacePoint& surface) const {
    const CompiledBlob& blob = scene.blobs[instance.shape];
    surface.is_refuted = is_wrong(blob, own, ray, hit, local, fields);
    TextureShare& share = surface.textures.front();
    share.surface = {instance.kind, instance.shape, 0, local};
    if (const scene::TextureId texture = blob.components.texture.front(); texture != scene::kNoTexture) {
      share.texture = texture;
      share.place = local;
      share.frame = own;
    }
    return -fields.gradient;
  }

  /// The normal of a solid or blob at a point in its own space, of any length. `surface` has one texture, which stays
  /// where the shape has none of its own. `ray` is that of the world.
  Vec3 shape_at(scene::Object::Kind kind, std::uint32_t shape, const TextureFrame& own, const Ray& ray, const Hit& hit,
                const Vec3& local, SurfacePoint& surface, TraceCounters& counters) const {
    std::vector<TextureShare>& textures = surface.textures;
    if (kind == scene::Object::Kind::solid) {
      textures.front().surface = {kind, shape, 0, local};
      return shading_normal_at(scene.solids[shape], hit.part, local, scene.details);
    }
    const TextureShare other = textures.front();
    textures.clear();
    BlobPoint& blob = thread_blob_point();
    const ShareRule rule{&scene.coordinate_textures, other.texture};
    if (is_published(settings.name)) {
      const PaperMemory* const records = settings.paper.reuse ? &thread_memory().paper : nullptr;
      entry_points->paper_point(scene.blobs[shape], hit.cell, records, settings.paper.eq10, local, rule, blob);
    } else {
      entry_points->blob_point(scene.blobs[shape], hit.cell, local, rule, blob);
      surface.is_refuted = is_wrong(scene.blobs[shape], own, ray, hit, local, blob.fields);
    }
    counters.shading_evaluations += blob.evaluations;
    double total = 0;
    for (const TextureShare& share : blob.shares) total += share.weight;
    for (const TextureShare& share : blob.shares) {
      const bool is_own = share.texture != scene::kNoTexture;
      textures.push_back({is_own ? share.texture : other.texture,
                          share.weight / total,
                          is_own ? local : other.place,
                          is_own ? own : other.frame,
                          {kind, shape, share.surface.component, local}});
    }
    // This happens only where the published solver takes a place far from every field for the surface.
    if (textures.empty()) textures.push_back(other);
    return -blob.fields.gradient;
  }
};

namespace {

/// Rays between two looks at the flag: a ray takes time in proportion to the longest list that it may meet, which is a
/// thousand in usual scenes, where a packet takes some microseconds, and 10⁶ where everything overlaps.
std::size_t rays_between_looks(const CompiledScene& scene) {
  constexpr std::size_t kItems = std::size_t{1} << 18;
  std::size_t longest = std::max(static_cast<std::size_t>(scene.crowd), scene.listed.size());
  for (const CompiledBlob& blob : scene.blobs) longest = std::max<std::size_t>(longest, blob.grid.longest_list);
  for (const CsgTree& tree : scene.trees) longest = std::max(longest, tree.leaves.size());
  return std::max(kItems / std::max<std::size_t>(longest, 1) / kPacket * kPacket, kPacket);
}

Vec3 position_of(const Ray& ray, const Hit& hit) { return ray.origin + ray.direction * hit.t; }

/// A point of the world in the instance's space.
Vec3 in_space_of(const Instance& instance, const Vec3& point) {
  return instance.is_placed ? instance.world_from_object.inverse_point(point) : point;
}

const scene::Transform* placing(const Instance& instance) {
  return instance.is_placed ? &instance.world_from_object : nullptr;
}
const scene::Transform* placing(const CsgLeaf& leaf) { return leaf.is_placed ? &leaf.group_from_leaf : nullptr; }

// A share is filled where it stays: to copy one that has just been made takes longer than to make it.

/// Gives a share the texture of an instance, at a point that is `local` in the instance's space. Its weight stays, and
/// so does the place on a shape, which textures may ask for.
void set_texture(TextureShare& share, const PlacedTexture& texture, const CompiledScene& scene,
                 const Instance& instance, const Vec3& world, const Vec3& local) {
  share.texture = texture.id;
  share.frame = {};
  if (texture.space == kOwnSpace) {
    share.place = local;
    share.frame.outer = placing(instance);
  } else if (texture.space == kOuterSpace) {
    share.place = world;
  } else {
    const scene::Transform& world_from_space = scene.texture_spaces[texture.space];
    share.place = world_from_space.inverse_point(world);
    share.frame.outer = &world_from_space;
  }
}

/// The same of a leaf of a tree, at a point in the space of the tree's group. Precondition: the leaf has a texture.
void set_texture(TextureShare& share, const PlacedTexture& texture, const Instance& instance, const CsgTree& tree,
                 const CsgLeaf& leaf, const Vec3& point) {
  share.texture = texture.id;
  share.frame = {placing(instance), nullptr};
  if (texture.space == kOwnSpace) {
    share.place = leaf.group_from_leaf.inverse_point(point);
    share.frame.inner = placing(leaf);
  } else if (texture.space == kOuterSpace) {
    share.place = point;
  } else {
    const scene::Transform& group_from_space = tree.texture_spaces[texture.space];
    share.place = group_from_space.inverse_point(point);
    share.frame.inner = &group_from_space;
  }
}

}  // namespace

Tracer::Tracer(const scene::Database& database, const TracerOptions& options)
    : impl_(std::make_shared<Impl>()), ray_steps_(options.run.steps_of_ray) {
  impl_->settings = {options.solver,  options.interpolants, options.tolerance, options.pixel_angle,      options.paper,
                     options.step,    options.relaxation,   options.packets,   options.run.steps_of_ray, options.digits,
                     options.run.stop};
  impl_->entry_points = trace_entry_points(options.simd);
  ISL_CHECK(impl_->entry_points != nullptr, "no vector target '{}'", options.simd);
  impl_->loops = &impl_->entry_points->loops;
  if (is_rival(options.solver)) {
    RivalLoops rivals = rival_loops(options.simd);
    if (rivals.loops == nullptr) {
      impl_->scene.refusal = {std::move(rivals.error), std::move(rivals.hint), database.settings.solver_origin};
      return;
    }
    impl_->loops = rivals.loops;
  }
  const CellRule cells = is_published(options.solver) ? CellRule::none
                         : options.octree             ? CellRule::lipschitz
                                                      : CellRule::ranges;
  impl_->scene = compile(
      database,
      {.cells = cells, .unblended = options.unblended, .most_grid_bytes = options.most_grid_bytes, .run = options.run});
  if (is_published(options.solver)) {
    const bool iso = options.solver == SolverName::iso;
    for (CompiledBlob& blob : impl_->scene.blobs) blob.paper = make_paper_tables(blob.components, iso);
  }
  if (!is_published(options.solver)) impl_->find_told_by_fields();
  impl_->rays_between_looks = rays_between_looks(impl_->scene);
}

Tracer::Tracer(std::shared_ptr<Impl> impl, std::uint64_t ray_steps) : impl_(std::move(impl)), ray_steps_(ray_steps) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;

Tracer Tracer::with_ray_steps(std::uint64_t most) const { return {impl_, most}; }

std::string Tracer::problem_of(SolverName solver) {
  if (!is_rival(solver)) return "";
  const RivalLoops rivals = rival_loops("");
  return rivals.error.empty() ? "" : fmt::format("{}; {}", rivals.error, rivals.hint);
}

bool Tracer::has_simd_target(const std::string& name) { return trace_entry_points(name) != nullptr; }

void Tracer::first_hits(std::span<const Ray> rays, std::span<Hit> hits, TraceCounters& counters, RayKind kind,
                        std::vector<CoincidingHit>* coinciding) const {
  ISL_CHECK(hits.size() == rays.size(), "{} {}", hits.size(), rays.size());
  thread_memory().coinciding = coinciding;
  impl_->in_parts(ray_steps_, rays.size(), [&](const SolverSettings& settings, std::size_t first, std::size_t count) {
    impl_->loops->first_hits(impl_->scene, settings, kind, rays.subspan(first, count), hits.subspan(first, count),
                             thread_memory(), counters);
  });
  thread_memory().coinciding = nullptr;
}

void Tracer::occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded, TraceCounters& counters,
                        RayKind kind) const {
  ISL_CHECK(occluded.size() == rays.size(), "{} {}", occluded.size(), rays.size());
  impl_->in_parts(ray_steps_, rays.size(), [&](const SolverSettings& settings, std::size_t first, std::size_t count) {
    impl_->loops->occlusions(impl_->scene, settings, kind, rays.subspan(first, count), occluded.subspan(first, count),
                             thread_memory(), counters);
  });
}

bool Tracer::may_meet_clear(const Ray& ray) const {
  return may_meet(impl_->scene.clear_bounds, ray.origin, ray.direction, ray.t_max);
}

void Tracer::visit_objects(const std::function<void(const PlacedObject&)>& visit) const {
  for (const Instance& instance : impl_->scene.instances) {
    scene::Object object = *instance.object;
    object.parent_from_object = instance.world_from_object;
    // The tree of a combination holds what it inherits of that, which its object does not know.
    if (instance.kind != scene::Object::Kind::group) object.inverse = instance.is_inverse;
    visit({object, {instance.holder, 0}, instance.interior, instance.is_hollow});
  }
}

void Tracer::set_blob_fields(std::span<const Ray> rays, std::span<const Hit> hits, std::span<const std::uint32_t> which,
                             std::span<BlobFields> fields, TraceCounters& counters) const {
  if (!impl_->some_are_told_by_fields) return;
  std::array<FieldQuery, kPacket> queries;
  std::array<BlobFields, kPacket> found;
  std::array<std::size_t, kPacket> asked_by;
  std::size_t count = 0;
  const CompiledBlob* blob = nullptr;
  const auto ask = [&] {
    if (count == 0) return;
    counters.shading_evaluations +=
        impl_->entry_points->blob_fields(*blob, std::span(queries).first(count), std::span(found).first(count));
    for (std::size_t i = 0; i < count; ++i) fields[asked_by[i]] = found[i];
    count = 0;
  };
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Hit& hit = hits[which[i]];
    const Instance& instance = impl_->scene.instances[hit.instance];
    if (!instance.is_told_by_fields) continue;
    const CompiledBlob* const own = &impl_->scene.blobs[instance.shape];
    if (own != blob || count == kPacket) ask();
    blob = own;
    queries[count] = {in_space_of(instance, position_of(rays[which[i]], hit)), hit.cell};
    asked_by[count++] = i;
  }
  ask();
}

void Tracer::surface_at(const Ray& ray, const Hit& hit, SurfacePoint& point, TraceCounters& counters) const {
  const std::uint32_t first = 0;
  BlobFields fields;
  set_blob_fields({&ray, 1}, {&hit, 1}, {&first, 1}, {&fields, 1}, counters);
  surface_at(ray, hit, fields, point, counters);
}

void Tracer::surface_at(const Ray& ray, const Hit& hit, const BlobFields& fields, SurfacePoint& point,
                        TraceCounters& counters) const {
  ISL_DCHECK(!hit.is_miss());
  const Instance& instance = impl_->scene.instances[hit.instance];
  point.position = position_of(ray, hit);
  point.is_lit_from_both_sides = instance.is_lit_from_both_sides;
  point.is_hollow = instance.is_hollow;
  point.interior = instance.interior;
  point.body = {instance.holder, 0};
  point.is_refuted = false;
  point.textures.resize(1);
  TextureShare& texture = point.textures.front();
  texture.weight = 1;
  const Vec3 local = in_space_of(instance, point.position);
  Vec3 normal;
  bool is_unit = !instance.is_placed;  // of solids whose normal no transform changes, it is that already
  if (instance.kind == scene::Object::Kind::group) {
    const CsgLeaf& leaf = impl_->scene.trees[instance.shape].leaves[hit.leaf];
    const CsgTree& tree = impl_->scene.trees[instance.shape];
    if (leaf.interior != scene::kNoInterior) {
      point.interior = leaf.interior;
      point.body.part = leaf.holder;
    }
    if (leaf.texture.id != scene::kNoTexture) {
      set_texture(texture, leaf.texture, instance, tree, leaf, local);
    } else {
      const CsgLeaf* const cut =
          instance.texture.id == scene::kNoTexture ? leaf_cut_away(impl_->scene, tree, leaf, local) : nullptr;
      if (cut)
        set_texture(texture, cut->texture, instance, tree, *cut, local);
      else
        set_texture(texture, instance.texture, impl_->scene, instance, point.position, local);
    }
    const Vec3 in_leaf = leaf.is_placed ? leaf.group_from_leaf.inverse_point(local) : local;
    const TextureFrame own{placing(instance), placing(leaf)};
    normal = impl_->shape_at(leaf.kind, leaf.shape, own, ray, hit, in_leaf, point, counters);
    is_unit &= !leaf.is_placed && leaf.kind == scene::Object::Kind::solid;
    if (leaf.is_placed) normal = leaf.group_from_leaf.normal(normal);
    if (leaf.is_inverse) normal = -normal;
  } else {
    set_texture(texture, instance.texture, impl_->scene, instance, point.position, local);
    const TextureFrame own{placing(instance), nullptr};
    normal = instance.is_told_by_fields
                 ? impl_->shape_of_fields(instance, own, ray, hit, local, fields, point)
                 : impl_->shape_at(instance.kind, instance.shape, own, ray, hit, local, point, counters);
    is_unit &= instance.kind == scene::Object::Kind::solid;
  }
  if (instance.is_placed) normal = instance.world_from_object.normal(normal);
  if (instance.is_inverse) normal = -normal;
  const double length = is_unit && normal != Vec3(0) ? 1 : normal.length();
  // A gradient of zero on the surface (a saddle exactly at the threshold) gives no normal; facing the ray is as good as
  // any.
  point.normal = length == 1 ? normal : length > 0 ? normal / length : -ray.direction;
  if (point.normal.dot(ray.direction) > 0) set_interior_texture(hit, local, point);
}

void Tracer::set_interior_texture(const Hit& hit, const Vec3& local, SurfacePoint& point) const {
  const Instance& instance = impl_->scene.instances[hit.instance];
  if (instance.kind == scene::Object::Kind::group) {
    const CsgTree& tree = impl_->scene.trees[instance.shape];
    const CsgLeaf& leaf = tree.leaves[hit.leaf];
    if (leaf.interior_texture.id != scene::kNoTexture) {
      for (TextureShare& share : point.textures) set_texture(share, leaf.interior_texture, instance, tree, leaf, local);
      return;
    }
  }
  if (instance.interior_texture.id == scene::kNoTexture) return;
  for (TextureShare& share : point.textures)
    set_texture(share, instance.interior_texture, impl_->scene, instance, point.position, local);
}

Face Tracer::face_at(const Hit& hit, const Vec3& point, const Vec3& reach) const {
  const BlobGradient gradient{impl_.get(),
                              [](void* context, std::uint32_t blob, std::uint32_t cell, const Vec3& place) {
                                const auto& self = *static_cast<Impl*>(context);
                                if (is_published(self.settings.name)) return Vec3(0);
                                BlobPoint& found = thread_blob_point();
                                const ShareRule rule{&self.scene.coordinate_textures, scene::kNoTexture};
                                self.entry_points->blob_point(self.scene.blobs[blob], cell, place, rule, found);
                                return found.fields.gradient;
                              }};
  return face_of(impl_->scene, hit, point, reach, gradient);
}

const std::optional<scene::Refusal>& Tracer::refusal() const { return impl_->scene.refusal; }

std::span<const LightGroup> Tracer::light_groups() const { return impl_->scene.light_groups; }

std::uint32_t Tracer::light_group_of(const Hit& hit) const { return impl_->scene.instances[hit.instance].light_group; }

bool Tracer::is_hidden(const Hit& hit, RayKind kind) const {
  return (impl_->scene.instances[hit.instance].hidden_from & static_cast<std::uint8_t>(kind)) != 0;
}

OriginId Tracer::origin_of(const Hit& hit) const { return impl_->scene.instances[hit.instance].origin; }

std::size_t Tracer::grid_bytes() const { return impl_->scene.grid_bytes(); }

std::string Tracer::grid_json() const { return render::grid_json(impl_->scene); }

const char* Tracer::simd_target() const { return impl_->entry_points->target; }

}  // namespace isl::render
