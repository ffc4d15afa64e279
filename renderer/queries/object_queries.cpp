#include "renderer/queries/object_queries.h"

#include "renderer/queries/inside.h"
#include "renderer/queries/subset.h"
#include "renderer/scene/unrendered.h"
#include "renderer/tracer.h"

#include <span>
#include <string>

namespace isl::render {

struct ObjectQueries::TracedShape {
  std::string untraceable;
  std::optional<Tracer> tracer;  ///< where untraceable is empty
};

ObjectQueries::ObjectQueries() = default;
ObjectQueries::~ObjectQueries() = default;

/// Kernels are added as a scene is read; another database means another scene.
void ObjectQueries::follow(const scene::Database& database) {
  if (database_ != &database) {
    database_ = &database;
    kernels_.clear();
    shapes_.clear();
    extents_.emplace(database);
  }
  for (std::size_t i = kernels_.size(); i < database.kernels.size(); ++i)
    kernels_.push_back(kernel_constants(database.kernels[i]));
}

ObjectQueries::TracedShape& ObjectQueries::shape_of(const scene::Database& database, const scene::Object& object) {
  follow(database);
  std::unique_ptr<TracedShape>& shape = shapes_[{object.kind, object.shape, object.clip, object.inverse}];
  if (shape) return *shape;
  shape = std::make_unique<TracedShape>();
  const scene::Database alone = subset(database, object);
  if (const std::vector<scene::Unrendered> things = scene::unrendered(alone); !things.empty()) {
    shape->untraceable = things[0].what;
  } else {
    TracerOptions options;
    options.solver = SolverName::exact;
    shape->tracer.emplace(alone, options);
  }
  return *shape;
}

std::string ObjectQueries::untraceable(const scene::Database& database, const scene::Object& object) {
  return shape_of(database, object).untraceable;
}

std::optional<scene::TracedPoint> ObjectQueries::trace(const scene::Database& database, const scene::Object& object,
                                                       const Vec3& origin, const Vec3& direction) {
  const Tracer& tracer = shape_of(database, object).tracer.value();
  Ray ray;
  ray.origin = object.parent_from_object.inverse_point(origin);
  ray.direction = object.parent_from_object.inverse_vector(direction);
  const double length = ray.direction.length();
  if (!(length > 0)) return std::nullopt;
  ray.direction /= length;
  Hit hit;
  TraceCounters counters;
  tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
  if (hit.is_miss()) return std::nullopt;
  SurfacePoint point;
  tracer.surface_at(ray, hit, point);
  return scene::TracedPoint{object.parent_from_object.point(point.position),
                            object.parent_from_object.normal(point.normal).normalized()};
}

bool ObjectQueries::inside(const scene::Database& database, const scene::Object& object, const Vec3& point) {
  follow(database);
  return is_inside(database, kernels_, object, point);
}

Imath::Box3d ObjectQueries::extent(const scene::Database& database, const scene::Object& object) {
  follow(database);
  return extents_->of(object);
}

}  // namespace isl::render
