// The reference field, compared with brute force: gradients with differences, enclosures with samples.
#include "renderer/reference/reference_field.h"

#include "renderer/reference/reference_ray.h"
#include "tests/reference/near.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

namespace isl::reference {
namespace {

Vector<long double> along(const LineOfSight& line, long double t) {
  return exactly(line.origin) + exactly(line.direction) * t;
}

TEST(ReferenceField, GradientIsTheDifferenceQuotient) {
  RandomSource random(12);
  for (int scene = 0; scene < 20; ++scene) {
    const scene::Database database = random_blob(random, {.components = 10});
    const ReferenceField field(database, database.blobs[0]);
    for (int i = 0; i < 50; ++i) {
      const LineOfSight line{random.in_ball(1), random.direction()};
      const FieldSample here = field.sample(exactly(line.origin));
      const long double step = 1e-7L;
      const long double difference = (field.value(along(line, step)) - field.value(along(line, -step))) / (2 * step);
      const long double size = std::sqrt(squared_length(here.gradient)) + here.sum_of_values;
      ASSERT_CLOSE(dot(here.gradient, exactly(line.direction)), difference, 1e-8L * size);
    }
  }
}

TEST(ReferenceField, BoxRangeHoldsEverySample) {
  RandomSource random(13);
  const scene::Database database = random_blob(random, {.components = 60});
  const ReferenceField field(database, database.blobs[0]);
  for (const ReferenceComponent& component : field.components()) {
    const scene::Vec3 centre = random.in_ball(1);
    const long double half = random.between(0.01, 0.3);
    const auto side = [&](double c) { return Interval(c - half, c + half); };
    const Interval range = component.range({side(centre.x), side(centre.y), side(centre.z)});
    for (int i = 0; i < 200; ++i) {
      const auto inside = [&](double c) { return c + half * static_cast<long double>(random.between(-1, 1)); };
      const long double value = component.sample({inside(centre.x), inside(centre.y), inside(centre.z)}).value;
      ASSERT_TRUE(range.contains(value)) << value << " not in [" << range.lo() << ", " << range.hi() << "]";
    }
  }
}

TEST(ReferenceField, RayRangesHoldEverySampleAndConvergeQuadratically) {
  RandomSource random(14);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const scene::Database database = random_blob(random, {.components = 5});
    const ReferenceField field(database, database.blobs[0]);
    const LineOfSight line = random_line(random, 2, 0.7);
    const FieldOnRay on_ray(field, {interval_of(line.origin), interval_of(line.direction)});
    if (on_ray.begin() > on_ray.end()) continue;
    const long double t0 = on_ray.begin() + (on_ray.end() - on_ray.begin()) * static_cast<long double>(random.unit());
    long double coarse = 0;
    for (const long double width : {0.1L, 0.01L, 0.001L, 0.0001L}) {
      const Jet range = on_ray.over(t0, t0 + width);
      Interval sampled = on_ray.at(t0).value;
      for (int k = 0; k <= 50; ++k) {
        const long double t = std::min(t0 + width * k / 50, t0 + width);
        const Jet here = on_ray.at(t);
        const FieldSample sample = field.sample(along(line, t));
        ASSERT_CLOSE(sample.value, here.value.middle(), 1e-16L * (sample.sum_of_values + 1));
        ASSERT_LE(range.value.lo(), here.value.hi());
        ASSERT_GE(range.value.hi(), here.value.lo());
        ASSERT_LE(range.slope.lo(), here.slope.hi());
        ASSERT_GE(range.slope.hi(), here.slope.lo());
        // A bend that is known to any digits lies among those of the stretch.
        if (here.bend.radius() < 1e-9L * here.bend.magnitude()) {
          ASSERT_LE(range.bend.lo(), here.bend.hi());
          ASSERT_GE(range.bend.hi(), here.bend.lo());
        }
        sampled = hull(sampled, here.value);
      }
      coarse = range.value.width() - sampled.width();
      ++checked;
    }
    const long double size = on_ray.magnitude_at(t0).values + on_ray.magnitude_at(t0).gradients + 1;
    // The stretch is 1e-4 wide, so an enclosure of first order would be off by about 1e-4 of the derivative's size.
    // Cones' kinks and thin components leave a factor in front of the square.
    ASSERT_LT(coarse, 1e-5L * size);
  }
  EXPECT_GT(checked, 400);
}

TEST(ReferenceField, ComponentTransformMovesTheField) {
  RandomSource random(15);
  scene::Database database = one_blob(gaussian(4), {cone({0, 0, 0}, 0.4, {1, 0.5, 0}, 0.2)});
  const ReferenceField plain(database, database.blobs[0]);
  database.transforms.push_back(random_transform(random, 1));
  database.blobs[0].components[0].transform = static_cast<scene::TransformId>(0);
  const ReferenceField moved(database, database.blobs[0]);
  for (int i = 0; i < 100; ++i) {
    const scene::Vec3 p = random.in_ball(1);
    const long double expected = plain.value(exactly(p));
    EXPECT_CLOSE(moved.value(exactly(database.transforms[0].point(p))), expected, 1e-13L * (1 + std::abs(expected)));
  }
}

}  // namespace
}  // namespace isl::reference
