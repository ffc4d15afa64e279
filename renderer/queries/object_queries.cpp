#include "renderer/queries/object_queries.h"

#include "renderer/queries/inside.h"
#include "renderer/queries/next_surface.h"
#include "renderer/queries/subset.h"
#include "renderer/trace/tracer.h"

namespace isl::render {

ObjectQueries::ObjectQueries() = default;
ObjectQueries::~ObjectQueries() = default;

/// Kernels are added as a scene is read, so only new ones are prepared. Another database means another scene.
void ObjectQueries::follow(const scene::Database& database) {
  if (database_ != &database) {
    database_ = &database;
    kernels_.clear();
    tracers_.clear();
    extents_.emplace(database, BlobBox::povray);
  }
  for (std::size_t i = kernels_.size(); i < database.kernels.size(); ++i)
    kernels_.push_back(kernel_constants(database.kernels[i]));
}

const Tracer& ObjectQueries::tracer_of(const scene::Database& database, const scene::Object& object) {
  follow(database);
  std::unique_ptr<Tracer>& tracer = tracers_[{object.kind, object.shape, object.clip, object.inverse}];
  if (!tracer) {
    TracerOptions options;
    options.solver = SolverName::exact;
    tracer = std::make_unique<Tracer>(subset(database, object), options);
  }
  return *tracer;
}

std::optional<scene::TracedPoint> ObjectQueries::trace(const scene::Database& database, const scene::Object& object,
                                                       const Vec3& origin, const Vec3& direction) {
  const Tracer& tracer = tracer_of(database, object);
  const std::optional<NextSurface> next = next_surface(tracer, object.parent_from_object, origin, direction);
  if (!next) return std::nullopt;
  SurfacePoint point;
  tracer.surface_at(next->ray, next->hit, point);
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
