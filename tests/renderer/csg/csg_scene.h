// Small scenes of combined solids and blobs, and lines that are followed through them from hit to hit.
#pragma once

#include "renderer/queries/inside.h"
#include "renderer/trace/tracer.h"
#include "tests/renderer/solids/membership.h"

#include <span>
#include <string>
#include <vector>

namespace isl::render::test {

using scene::Object;
using scene::Operation;

/// Builds a database with one object.
class CsgScene {
 public:
  Object solid(const scene::Solid& solid) {
    database.solids.push_back(solid);
    return object(Object::Kind::solid, database.solids.size() - 1);
  }
  Object algebraic(const scene::Polynomial& polynomial) {
    database.polynomials.push_back(polynomial);
    scene::Solid solid;
    solid.kind = scene::SolidKind::poly;
    solid.detail = static_cast<std::uint32_t>(database.polynomials.size() - 1);
    return this->solid(solid);
  }
  Object blob(const std::vector<scene::Component>& components, double threshold) {
    if (database.kernels.empty()) database.kernels.resize(1);
    scene::Blob blob{.threshold = threshold, .components = {}, .origins = {}};
    for (const scene::Component& component : components) blob.components.push_back(component);
    blob.origins.resize(blob.components.size());
    database.blobs.push_back(blob);
    return object(Object::Kind::blob, database.blobs.size() - 1);
  }
  Object group(Operation operation, std::vector<Object> children) {
    database.groups.push_back({.operation = operation, .children = std::move(children)});
    return object(Object::Kind::group, database.groups.size() - 1);
  }
  Object clipped(Object object, std::vector<Object> by) {
    object.clip = scene::GroupId{group(Operation::intersect, std::move(by)).shape};
    return object;
  }

  [[nodiscard]] bool inside(const Vec3& point) const {
    std::vector<KernelConstants> kernels;
    for (const scene::Kernel& kernel : database.kernels) kernels.push_back(kernel_constants(kernel));
    StepCounter steps;
    return is_inside(database, kernels, database.objects[0], point, steps);
  }

  scene::Database database;

 private:
  static Object object(Object::Kind kind, std::size_t shape) {
    Object result;
    result.kind = kind;
    result.shape = static_cast<std::uint32_t>(shape);
    return result;
  }
};

inline scene::Solid box(const Vec3& a, const Vec3& b) {
  scene::Solid solid;
  solid.kind = scene::SolidKind::box;
  solid.a = a;
  solid.b = b;
  return solid;
}
inline scene::Solid sphere(const Vec3& centre, double radius) {
  scene::Solid solid;
  solid.a = centre;
  solid.radius_a = radius;
  return solid;
}
inline scene::Solid plane(const Vec3& normal, double distance) {
  scene::Solid solid;
  solid.kind = scene::SolidKind::plane;
  solid.a = normal;
  solid.radius_a = distance;
  return solid;
}

inline scene::Transform affine(const scene::Matrix& matrix) { return {matrix, matrix.gjInverse()}; }

inline scene::Transform random_transform(Random& random) {
  scene::Matrix scale, rotation, shift;
  scale.setScale(Vec3(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5)));
  rotation.setAxisAngle(random.direction(), random.uniform(0, 6));
  shift.setTranslation(random.in_cube(0.5));
  return affine(scale * rotation * shift);
}

/// All surfaces along a line, each found by a ray that starts on the one before. A correct tracer finds far fewer than
/// `most`.
struct Walk {
  std::vector<double> t;
  std::vector<Hit> hits;
};
inline Walk walk(const Tracer& tracer, const Vec3& origin, const Vec3& direction, std::size_t most = 200) {
  Walk result;
  TraceCounters counters;
  Ray ray{origin, direction, std::numeric_limits<double>::infinity(), 0, {}};
  double travelled = 0;
  while (result.t.size() < most) {
    Hit hit;
    tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
    if (hit.is_miss()) break;
    travelled += hit.t;
    result.t.push_back(travelled);
    result.hits.push_back(hit);
    ray.origin = ray.origin + ray.direction * hit.t;
    ray.path_length = travelled;
    ray.start = hit.start();
  }
  return result;
}

}  // namespace isl::render::test
