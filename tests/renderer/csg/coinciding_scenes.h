// Scenes of objects whose faces coincide except for the rounding of their places, and rays that look at them.
#pragma once

#include "tests/renderer/csg/csg_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::render::test {

inline scene::Transform shifted(const Vec3& by) {
  scene::Matrix m;
  m.setTranslation(by);
  return affine(m);
}

/// A rigid transform for a scene, and ways of placing objects there that have the same meaning and different rounding.
struct Place {
  double scale;
  scene::Transform transform;

  explicit Place(Random& random) : scale(std::pow(10, random.uniform(-6, 6))) {
    scene::Matrix size, turn;
    size.setScale(Vec3(scale));
    turn.setAxisAngle(random.direction(), random.uniform(0, 6));
    transform = then(affine(size * turn), shifted(random.direction() * scale * std::pow(10, random.uniform(-1, 2))));
  }
  [[nodiscard]] scene::Transform once_more(Random& random) const {
    const Vec3 by = random.in_cube(1);
    return then(then(shifted(by), shifted(-by)), transform);
  }
};

/// An object that is flat in the plane y = 0 and lies below it, and its place.
struct Flat {
  Object object;
  int form;  ///< 0: unbounded, 1: a square, 2: a circle, 3: a triangle
  double x = 0, z = 0, size = 0;

  /// The distance of a point of the plane from the flat's border; negative outside.
  [[nodiscard]] double depth(double px, double pz) const {
    const double dx = px - x, dz = pz - z;
    if (form == 0) return 1e9;
    if (form == 1) return size - std::max(std::abs(dx), std::abs(dz));
    if (form == 2) return size - std::hypot(dx, dz);
    return std::min({size - dx - dz, dx, dz});
  }
};

inline Flat random_flat(CsgScene& scene, Random& random) {
  Flat flat{{}, 1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0.3, 1)};
  const Vec3 centre(flat.x, 0, flat.z);
  const double s = flat.size;
  scene::Solid solid = box(centre - Vec3(s, random.uniform(0.1, 1), s), centre + Vec3(s, 0, s));
  switch (static_cast<int>(random.uniform(0, 8))) {
    case 0:
      flat.form = 0;
      solid = plane({0, 1, 0}, 0);
      break;
    case 1:
      flat.form = 2;
      solid.kind = scene::SolidKind::disc;
      solid.a = centre;
      solid.b = {0, 1, 0};
      solid.radius_a = s;
      break;
    case 2:
      flat.form = 2;
      solid.kind = scene::SolidKind::cylinder;
      solid.a = centre;
      solid.b = centre - Vec3(0, 0.7, 0);
      solid.radius_a = s;
      break;
    case 3:
      flat.form = 3;
      solid.kind = scene::SolidKind::triangle;
      solid.detail = static_cast<std::uint32_t>(scene.database.triangles.size());
      scene.database.triangles.push_back({{centre, centre + Vec3(s, 0, 0), centre + Vec3(0, 0, s)}, {}});
      break;
    case 4:
      solid.kind = scene::SolidKind::polygon;
      solid.detail = static_cast<std::uint32_t>(scene.database.polygons.size());
      scene.database.polygons.push_back({{centre + Vec3(-s, 0, -s), centre + Vec3(s, 0, -s), centre + Vec3(s, 0, s),
                                          centre + Vec3(-s, 0, s), centre + Vec3(-s, 0, -s)}});
      break;
    case 5:  // a half-space cuts off sides that reach beyond the top
      flat.object = scene.group(Operation::intersect, {scene.solid(box(centre - Vec3(s, 1, s), centre + Vec3(s, 1, s))),
                                                       scene.solid(plane({0, 1, 0}, 0))});
      return flat;
    default: break;
  }
  flat.object = scene.solid(solid);
  return flat;
}

struct Scene {
  CsgScene scene;
  std::vector<Flat> flats;

  void put(const Object& object, const scene::Transform& transform) {
    scene.database.objects.push_back(object);
    scene.database.objects.back().parent_from_object = transform;
  }
};

inline Hit first_hit(const Tracer& tracer, const Ray& ray) {
  Hit hit;
  TraceCounters counters;
  tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
  return hit;
}
inline bool is_occluded(const Tracer& tracer, const Ray& ray) {
  std::uint8_t occluded = 0;
  TraceCounters counters;
  tracer.occlusions(std::span(&ray, 1), std::span(&occluded, 1), counters);
  return occluded == kOccluded;
}

inline Ray ray_from(const Vec3& origin, const Vec3& direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction.normalized();
  return ray;
}
inline Ray shadow_ray(const Ray& ray, const Hit& hit, const Vec3& direction) {
  Ray result = ray_from(ray.origin + ray.direction * hit.t, direction);
  result.path_length = hit.t;
  result.start = hit.start();
  return result;
}

/// A direction from the plane upwards, as low as 10⁻⁷.
inline Vec3 upwards(Random& random) {
  const double turn = random.uniform(0, 6.3), rise = std::pow(10, random.uniform(-7, 0.5));
  return Vec3(std::cos(turn), rise, std::sin(turn)).normalized();
}

/// Calls use(point in the plane, ray, hit) for rays from above.
template <class Use>
void look_down(const Tracer& tracer, const Place& place, Random& random, int count, const Use& use) {
  for (int i = 0; i < count; ++i) {
    const Vec3 point(random.uniform(-1.2, 1.2), 0, random.uniform(-1.2, 1.2));
    const Vec3 view = upwards(random) * Vec3(1, 3, 1) + Vec3(0, 0.03, 0);
    const Ray ray = ray_from(place.transform.point(point + view * std::pow(10, random.uniform(0, 3))),
                             -place.transform.vector(view));
    const Hit hit = first_hit(tracer, ray);
    use(point, ray, hit);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// A random object of about unit size.
inline Object random_round(CsgScene& scene, Random& random, int form) {
  switch (form) {
    case 0: return scene.solid(sphere(random.in_cube(0.3), random.uniform(0.3, 1)));
    case 1: return scene.solid(random_solid(random, scene::SolidKind::cylinder));
    case 2: return scene.solid(random_solid(random, scene::SolidKind::cone));
    case 3: return scene.solid(random_whole(random, scene::SolidKind::torus).solid);
    case 4: return scene.algebraic(algebraic(2, {1, 0.2, 0, 0, 0.6, 0.1, 0, 0.8, 0, -0.5}).polynomial);
    case 5: {
      std::vector<scene::Component> components(3);
      for (scene::Component& c : components) c.a = random.in_cube(0.4), c.radius_a = 0.9, c.strength = 1;
      return scene.blob(components, 0.3);
    }
    default:
      return scene.group(Operation::merge,
                         {scene.solid(sphere({0.4, 0, 0}, 0.7)), scene.solid(box(Vec3(-0.6), Vec3(0.4)))});
  }
}

}  // namespace isl::render::test
