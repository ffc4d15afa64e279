// Separate objects whose faces coincide except for the rounding of their places: which is seen, and what throws a
// shadow. Sizes are 10⁻⁶ to 10⁶, places up to 100 sizes from the origin, light down to 10⁻⁷ above the faces.
#include "tests/renderer/csg/coinciding_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render::test {
namespace {

TEST(CoincidingFaces, show_what_was_declared_first_and_throw_no_shadow_on_each_other) {
  Random random(601);
  int seen = 0;
  for (int turn = 0; turn < 300; ++turn) {
    Scene all;
    const Place place(random);
    const int count = 2 + static_cast<int>(random.uniform(0, 5));
    for (int i = 0; i < count; ++i) {
      all.flats.push_back(random_flat(all.scene, random));
      all.put(all.flats.back().object, place.once_more(random));
    }
    const Tracer tracer(all.scene.database, {});
    look_down(tracer, place, random, 100, [&](const Vec3& p, const Ray& ray, const Hit& hit) {
      InstanceId expected = scene::kNone;
      bool is_clear = true;
      for (std::size_t i = all.flats.size(); i-- > 0;) {
        const double depth = all.flats[i].depth(p.x, p.z);
        is_clear &= std::abs(depth) > 1e-5;
        if (depth > 0) expected = static_cast<InstanceId>(i);
      }
      if (!is_clear || expected == scene::kNone) return;
      ++seen;
      ASSERT_EQ(hit.instance, expected) << "turn " << turn << " at " << p;
      for (int light = 0; light < 4; ++light) {
        const Vec3 up = upwards(random);
        ASSERT_FALSE(is_occluded(tracer, shadow_ray(ray, hit, place.transform.vector(up))))
            << "turn " << turn << " at " << p << " towards " << up;
      }
    });
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen, 10000);
}

/// Tells whether the ray from p in the plane along d passes the box from a to b; `unclear` if it does so for the box
/// grown by the margin and not for the box shrunk by it.
enum class Shade { none, full, unclear };
Shade shade(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& d, double margin) {
  long double in[2], out[2];
  for (int grown = 0; grown < 2; ++grown) {
    const long double by = grown ? margin : -margin;
    in[grown] = 0, out[grown] = std::numeric_limits<long double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      // The lower face is exact, because it is the one that may coincide.
      const long double low = a[axis] - (axis == 1 ? 0 : by), high = b[axis] + by;
      const long double t0 = (low - p[axis]) / d[axis], t1 = (high - p[axis]) / d[axis];
      in[grown] = std::max(in[grown], std::min(t0, t1));
      out[grown] = std::min(out[grown], std::max(t0, t1));
    }
  }
  if (in[0] < out[0]) return Shade::full;
  return in[1] < out[1] ? Shade::unclear : Shade::none;
}

TEST(CoincidingFaces, are_shadowed_by_what_stands_on_them_or_hovers_close_above) {
  Random random(602);
  int shaded = 0, lit = 0;
  for (int turn = 0; turn < 300; ++turn) {
    Scene all;
    const Place place(random);
    for (int i = 0; i < 2; ++i) {
      all.flats.push_back(random_flat(all.scene, random));
      all.put(all.flats.back().object, place.once_more(random));
    }
    // A plane at 10⁻⁸ sizes is far above the rounding of places 100 sizes away.
    const double above = turn % 3 == 0 ? 0 : std::pow(10, random.uniform(-8, -1));
    const Vec3 a(random.uniform(-0.5, 0.2), above, random.uniform(-0.5, 0.2));
    const Vec3 b = a + Vec3(random.uniform(0.1, 0.5), random.uniform(0.1, 0.5), random.uniform(0.1, 0.5));
    all.put(all.scene.solid(box(a, b)), place.once_more(random));
    const Tracer tracer(all.scene.database, {});
    look_down(tracer, place, random, 60, [&](const Vec3& p, const Ray& ray, const Hit& hit) {
      if (hit.is_miss() || hit.instance == 2) return;
      if (std::max(all.flats[0].depth(p.x, p.z), all.flats[1].depth(p.x, p.z)) < 1e-5)
        return;  // a side of the object, below the plane
      for (int light = 0; light < 4; ++light) {
        const Vec3 up = upwards(random);
        const Shade expected = shade(a, b, p, up, 1e-6);
        if (expected == Shade::unclear) continue;
        // If the light grazes, rounding alone decides whether it meets the box's lower border.
        if (above > 0 && std::abs(above / up.y) > 1e-7 * above / 1e-13) continue;
        ++(expected == Shade::full ? shaded : lit);
        ASSERT_EQ(is_occluded(tracer, shadow_ray(ray, hit, place.transform.vector(up))), expected == Shade::full)
            << "turn " << turn << " at " << p << " towards " << up << " box " << a << b;
      }
    });
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(shaded, 1000);
  EXPECT_GT(lit, 10000);
}

TEST(CoincidingFaces, of_the_same_object_twice_look_like_one) {
  Random random(603);
  int seen = 0;
  for (int turn = 0; turn < 280; ++turn) {
    Scene twice, once;
    const Place place(random);
    const Object object = random_round(twice.scene, random, turn % 7);
    once.scene.database = twice.scene.database;
    twice.put(object, place.once_more(random));
    once.put(object, twice.scene.database.objects[0].parent_from_object);
    twice.put(object, place.once_more(random));
    const Tracer tracer(twice.scene.database, {}), alone(once.scene.database, {});
    for (int i = 0; i < 60; ++i) {
      const Vec3 direction = random.direction();
      const Vec3 from = random.in_cube(0.5) - direction * std::pow(10, random.uniform(0.5, 2));
      const Ray ray = ray_from(place.transform.point(from), place.transform.vector(direction));
      const Hit hit = first_hit(tracer, ray), expected = first_hit(alone, ray);
      if (hit.is_miss() != expected.is_miss()) {
        // One of the two objects may be missed if the ray only grazes it.
        continue;
      }
      if (hit.is_miss()) continue;
      ++seen;
      ASSERT_EQ(hit.instance, 0u) << "turn " << turn;
      SurfacePoint point;
      alone.surface_at(ray, expected, point);
      for (int light = 0; light < 6; ++light) {
        // Light in all directions, and from as low as 10⁻⁷ above the surface.
        Vec3 to = random.direction();
        if (light % 2 == 0) {
          to = (to - point.normal * to.dot(point.normal)).normalized() +
               point.normal * std::pow(10, random.uniform(-7, 0));
        }
        ASSERT_EQ(is_occluded(tracer, shadow_ray(ray, hit, to)), is_occluded(alone, shadow_ray(ray, expected, to)))
            << "turn " << turn << " from " << from << " along " << direction << " to " << to << " "
            << point.normal.dot(to.normalized());
      }
    }
  }
  EXPECT_GT(seen, 5000);
}

TEST(CoincidingFaces, are_the_same_to_rays_in_packets) {
  Random random(605);
  std::size_t first = 0;
  for (int turn = 0; turn < 70; ++turn) {
    Scene twice;
    const Place place(random);
    const Object object = random_round(twice.scene, random, turn % 7);
    for (int copy = 0; copy < 2 + turn % 3; ++copy) twice.put(object, place.once_more(random));
    const Tracer tracer(twice.scene.database, {});
    std::vector<Ray> rays, shadow_rays;
    for (int i = 0; i < 64; ++i) {
      const Vec3 direction = random.direction();
      const Vec3 from = random.in_cube(0.5) - direction * 8;
      rays.push_back(ray_from(place.transform.point(from), place.transform.vector(direction)));
    }
    TraceCounters counters;
    std::vector<Hit> hits(rays.size());
    tracer.first_hits(rays, hits, counters);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit alone = first_hit(tracer, rays[i]);
      ASSERT_EQ(hits[i].instance, alone.instance) << "turn " << turn;
      if (hits[i].is_miss()) continue;
      ASSERT_EQ(hits[i].instance, 0u) << "turn " << turn;
      ++first;
      shadow_rays.push_back(shadow_ray(rays[i], hits[i], random.direction()));
    }
    std::vector<std::uint8_t> occluded(shadow_rays.size());
    tracer.occlusions(shadow_rays, occluded, counters);
    for (std::size_t i = 0; i < shadow_rays.size(); ++i) {
      ASSERT_EQ(occluded[i] == kOccluded, is_occluded(tracer, shadow_rays[i])) << "turn " << turn;
    }
  }
  EXPECT_GT(first, 1000u);
}

TEST(CoincidingFaces, that_end_where_the_next_begins_throw_no_shadow_across_the_border) {
  // A ray that starts just before the border and just above one box's top may enter the next box through its side, and
  // leave it through its top, which is higher by a rounding.
  Random random(604);
  int seen = 0;
  for (int turn = 0; turn < 400; ++turn) {
    Scene all;
    const Place place(random);
    const Object left = all.scene.solid(box({-1, -1, -1}, {0, 0, 1}));
    Object right = all.scene.solid(box({0, -1, -1}, {1, 0, 1}));
    if (turn % 2 == 0) {
      all.put(left, place.transform);
      all.put(right, place.once_more(random));
    } else {
      const Vec3 by = random.in_cube(1);
      right.parent_from_object = then(shifted(by), shifted(-by));
      all.put(all.scene.group(Operation::merge, {left, right}), place.transform);
    }
    const Tracer tracer(all.scene.database, {});
    for (int i = 0; i < 100; ++i) {
      const Vec3 point(-std::pow(10, random.uniform(-12, -6)), 0, random.uniform(-0.9, 0.9));
      const Ray ray = ray_from(place.transform.point(point + Vec3(0, 3, 0)), place.transform.vector({0, -1, 0}));
      const Hit hit = first_hit(tracer, ray);
      ASSERT_FALSE(hit.is_miss());
      const Vec3 up = Vec3(1, std::pow(10, random.uniform(-7, -2)), random.uniform(-0.3, 0.3));
      ++seen;
      ASSERT_FALSE(is_occluded(tracer, shadow_ray(ray, hit, place.transform.vector(up)))) << turn << " at " << point;
    }
  }
  EXPECT_GT(seen, 10000);
}

}  // namespace
}  // namespace isl::render::test
