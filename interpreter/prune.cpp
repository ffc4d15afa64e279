#include "interpreter/prune.h"

#include "interpreter/prune_textures.h"

#include <cstdint>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Database;
using scene::Object;

class Pruner {
 public:
  explicit Pruner(Database& database)
      : database_(database),
        blobs_(database.blobs.size()),
        solids_(database.solids.size()),
        polynomials_(database.polynomials.size()),
        triangles_(database.triangles.size()),
        polygons_(database.polygons.size()),
        groups_(database.groups.size()),
        transforms_(database.transforms.size()),
        kernels_(database.kernels.size()),
        textures_(database) {}

  void run() {
    reach(database_.objects);
    reach(database_.lights);
    textures_.reach_world(transforms_);
    // Groups hold groups, textures hold textures and a pattern may hold an object: lists of what is still to be looked
    // at, so that depth costs no stack.
    while (!pending_.empty() || textures_.advance(transforms_, [this](const Object& object) { reach(object); })) {
      if (pending_.empty()) continue;
      const std::uint32_t group = pending_.back();
      pending_.pop_back();
      reach(database_.groups[group].children);
      reach(database_.groups[group].lights);
    }
    blobs_.compact(database_.blobs);
    solids_.compact(database_.solids);
    polynomials_.compact(database_.polynomials);
    triangles_.compact(database_.triangles);
    polygons_.compact(database_.polygons);
    groups_.compact(database_.groups);
    transforms_.compact(database_.transforms);
    kernels_.compact(database_.kernels);
    textures_.compact(transforms_);
    renumber(database_.objects);
    renumber(database_.pattern_objects);
    renumber(database_.lights);
    for (scene::Group& group : database_.groups) {
      renumber(group.children);
      renumber(group.lights);
    }
    for (scene::Solid& solid : database_.solids) {
      if (Column* const details = details_of(solid)) solid.detail = details->place(solid.detail);
    }
    for (scene::Blob& blob : database_.blobs) renumber(blob);
  }

 private:
  void reach(const std::vector<Object>& objects) {
    for (const Object& object : objects) reach(object);
  }

  void reach(const Object& object) {
    textures_.reach(object.texture);
    textures_.reach(object.interior_texture);
    textures_.reach(object.interior);
    reach(object.clip);
    reach(object.bound);
    switch (object.kind) {
      case Object::Kind::solid: reach_solid(object.shape); break;
      case Object::Kind::group: reach(scene::GroupId{object.shape}); break;
      case Object::Kind::blob:
        if (blobs_.reach(object.shape)) reach(database_.blobs[object.shape]);
        break;
    }
  }

  void reach(scene::GroupId group) {
    if (group != scene::kNoGroup && groups_.reach(index(group))) pending_.push_back(index(group));
  }

  void reach(const std::vector<scene::Light>& lights) {
    for (const scene::Light& light : lights) reach(light.projected_through);
  }

  void reach_solid(std::uint32_t i) {
    solids_.reach(i);
    if (Column* const details = details_of(database_.solids[i])) details->reach(database_.solids[i].detail);
  }

  /// The column that holds what does not fit into the solid's own record; null where everything does.
  Column* details_of(const scene::Solid& solid) {
    if (scene::is_polynomial(solid.kind)) return &polynomials_;
    if (scene::is_triangle(solid.kind)) return &triangles_;
    return solid.kind == scene::SolidKind::polygon ? &polygons_ : nullptr;
  }

  void reach(const scene::Blob& blob) {
    for (const scene::Component& component : blob.components) {
      textures_.reach(component.texture);
      if (component.transform != scene::kIdentity) transforms_.reach(index(component.transform));
      kernels_.reach(index(component.kernel));
    }
  }

  void renumber(std::vector<Object>& objects) {
    for (Object& object : objects) {
      const Column& column = object.kind == Object::Kind::solid  ? solids_
                             : object.kind == Object::Kind::blob ? blobs_
                                                                 : groups_;
      object.shape = column.place(object.shape);
      textures_.renumber(object.texture);
      textures_.renumber(object.interior_texture);
      textures_.renumber(object.interior);
      renumber(object.clip);
      renumber(object.bound);
    }
  }

  void renumber(scene::GroupId& group) const {
    if (group != scene::kNoGroup) group = scene::GroupId{groups_.place(index(group))};
  }

  void renumber(std::vector<scene::Light>& lights) const {
    for (scene::Light& light : lights) renumber(light.projected_through);
  }

  void renumber(scene::Blob& blob) {
    for (scene::Component& c : blob.components) {
      textures_.renumber(c.texture);
      if (c.transform != scene::kIdentity) c.transform = scene::TransformId{transforms_.place(index(c.transform))};
      c.kernel = scene::KernelId{static_cast<std::uint16_t>(kernels_.place(index(c.kernel)))};
    }
  }

  Database& database_;
  Column blobs_, solids_, polynomials_, triangles_, polygons_, groups_, transforms_, kernels_;
  TexturePruner textures_;
  std::vector<std::uint32_t> pending_;
};

}  // namespace

void prune(Database& database) { Pruner(database).run(); }

}  // namespace isl::interpreter
