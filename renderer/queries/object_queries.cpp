#include "renderer/queries/object_queries.h"

#include "renderer/queries/inside.h"
#include "renderer/queries/next_surface.h"
#include "renderer/queries/subset.h"
#include "renderer/trace/tracer.h"

namespace isl::render {

/// The tracer refers to the database.
struct ObjectQueries::TracedShape {
  TracedShape(const scene::Database& scene, const scene::Object& object, const TracerOptions& options)
      : database(subset(scene, object)), tracer(database, options) {}

  scene::Database database;
  Tracer tracer;
};

ObjectQueries::ObjectQueries() = default;
ObjectQueries::~ObjectQueries() = default;

/// Kernels are added as a scene is read, so only new ones are prepared. Another database means another scene.
void ObjectQueries::follow(const scene::Database& database) {
  if (database_ != &database) {
    database_ = &database;
    kernels_.clear();
    shapes_.clear();
    extents_.emplace(database, BlobBox::povray);
  }
  for (std::size_t i = kernels_.size(); i < database.kernels.size(); ++i)
    kernels_.push_back(kernel_constants(database.kernels[i]));
}

const Tracer& ObjectQueries::tracer_of(const scene::Database& database, const scene::Object& object) {
  follow(database);
  std::unique_ptr<TracedShape>& shape = shapes_[{object.kind, object.shape, object.clip, object.inverse}];
  if (!shape) {
    TracerOptions options;
    options.solver = SolverName::exact;
    shape = std::make_unique<TracedShape>(database, object, options);
  }
  return shape->tracer;
}

scene::TraceAnswer ObjectQueries::trace(const scene::Database& database, const scene::Object& object,
                                        const Vec3& origin, const Vec3& direction) {
  const Tracer& tracer = tracer_of(database, object);
  const NextSurface next = next_surface(tracer, object.parent_from_object, origin, direction);
  if (next.hit.is_miss()) return {std::nullopt, next.is_certain};
  SurfacePoint point;
  tracer.surface_at(next.ray, next.hit, point);
  return {scene::TracedPoint{object.parent_from_object.point(point.position),
                             object.parent_from_object.normal(point.normal).normalized()},
          next.is_certain && !point.is_refuted};
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
