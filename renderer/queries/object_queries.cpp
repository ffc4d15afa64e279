#include "renderer/queries/object_queries.h"

#include "renderer/queries/next_surface.h"
#include "renderer/trace/tracer.h"

#include <fmt/format.h>

#include <utility>

namespace isl::render {

ObjectQueries::ObjectQueries(const RunLimits& run) : run_(run) {}
ObjectQueries::~ObjectQueries() = default;

/// Another database means another scene.
void ObjectQueries::follow(const scene::Database& database) {
  if (database_ != &database) {
    database_ = &database;
    shapes_.clear();
    insides_.emplace(database, run_);
    extents_.emplace(database, BoxRule::povray);
  }
  insides_->follow();
}

const Tracer* ObjectQueries::tracer_of(const scene::Database& database, const scene::Object& object) {
  follow(database);
  const ShapeKey key{object.kind, object.shape, object.clip, object.inverse};
  if (const auto known = shapes_.find(key); known != shapes_.end()) return &known->second->tracer();
  std::unique_ptr<const ObjectTracer> made = ObjectTracer::of(database, object, run_, refusal_);
  if (!made && !shapes_.empty() && !is_set(run_.stop)) {
    // What was prepared for earlier questions can be prepared again.
    shapes_.clear();
    refusal_.reset();
    made = ObjectTracer::of(database, object, run_, refusal_);
  }
  return made ? &shapes_.emplace(key, std::move(made)).first->second->tracer() : nullptr;
}

scene::TraceAnswer ObjectQueries::trace(const scene::Database& database, const scene::Object& object,
                                        const Vec3& origin, const Vec3& direction) {
  refusal_.reset();
  const Tracer* const tracer = tracer_of(database, object);
  if (tracer == nullptr) return {std::nullopt, false};
  const NextSurface next = next_surface(*tracer, object.parent_from_object, origin, direction);
  if (next.hit.is_miss()) return {std::nullopt, next.is_certain};
  SurfacePoint point;
  tracer->surface_at(next.ray, next.hit, point);
  return {scene::TracedPoint{object.parent_from_object.point(point.position),
                             object.parent_from_object.normal(point.normal).normalized()},
          next.is_certain && !point.is_refuted};
}

template <class Ask>
auto ObjectQueries::ask_insides(const scene::Database& database, const Ask& ask) {
  follow(database);
  refusal_.reset();
  StepCounter steps(run_.steps_at_point, run_.stop);
  const auto answer = ask(steps);
  if (steps.is_spent()) {
    refusal_ = {fmt::format("this object has parts that take more than {:g} steps to ask",
                            static_cast<double>(run_.steps_at_point)),
                "`--max-turns` raises the limit"};
  }
  return answer;
}

bool ObjectQueries::inside(const scene::Database& database, const scene::Object& object, const Vec3& point) {
  return ask_insides(database, [&](StepCounter& steps) { return insides_->is_inside(object, point, steps); });
}

double ObjectQueries::field(const scene::Database& database, const scene::Object& object, const Vec3& point) {
  return ask_insides(database, [&](StepCounter& steps) { return insides_->field_of(object, point, steps); });
}

Imath::Box3d ObjectQueries::extent(const scene::Database& database, const scene::Object& object) {
  follow(database);
  refusal_.reset();
  return extents_->of(object);
}

}  // namespace isl::render
