// The reference field against brute force: distances by minimising over the skeleton, gradients by differences,
// enclosures by sampling.
#include "tests/reference/reference_field.h"

#include "tests/reference/near.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/reference_ray.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

namespace isl::reference {
namespace {

Vector<long double> along(const LineOfSight& line, long double t) {
  return exactly(line.origin) + exactly(line.direction) * t;
}

/// The least value of f on [low, high] by ternary search, good where f falls and then rises; (2/3)⁶⁰ = 3e-11 of a place
/// is 1e-21 of a value.
template <class Function>
long double ternary_minimum(const Function& f, long double low, long double high) {
  long double least = std::min(f(low), f(high));
  for (int step = 0; step < 60; ++step) {
    const long double left = low + (high - low) / 3, right = high - (high - low) / 3;
    const long double at_left = f(left), at_right = f(right);
    (at_left < at_right ? high : low) = at_left < at_right ? right : left;
    least = std::min({least, at_left, at_right});
  }
  return least;
}

/// The same in each of 64 stretches.
template <class Function>
long double stretchwise_minimum(const Function& f, long double low, long double high) {
  long double least = f(low);
  for (int stretch = 0; stretch < 64; ++stretch) {
    const auto at = [&](int i) { return low + (high - low) * i / 64; };
    least = std::min(least, ternary_minimum(f, at(stretch), at(stretch + 1)));
  }
  return least;
}

/// min over v of |p − c(v)|²/r(v)².
long double brute_force_q(const scene::Component& cone, const Vector<long double>& p) {
  const Vector<long double> a = exactly(cone.a), axis = exactly(cone.b) - a;
  const auto quotient = [&](long double v) {
    const long double radius = cone.radius_a + (static_cast<long double>(cone.radius_b) - cone.radius_a) * v;
    return squared_length(p - a - axis * v) / (radius * radius);
  };
  return stretchwise_minimum(quotient, 0, 1);
}

TEST(ReferenceField, ConeIsTheNearestOfAllItsSpheres) {
  const std::vector<scene::Component> cones = {
      cone({0, 0, 0}, 0.5, {2, 0, 0}, 0.2),       // tapering
      cone({0, 0, 0}, 0.2, {1, 1, 0.5}, 0.6),     // widening, oblique
      cone({0, 0, 0}, 0.3, {1, 0, 0}, 0.3),       // a segment in disguise
      cone({0, 0, 0}, 1.5, {1, 0, 0}, 0.2),       // one end sphere holds the other
      cone({0, 0, 0}, 0.25, {0.01, 0, 0}, 0.251)  // nearly concentric
  };
  RandomSource random(11);
  for (const scene::Component& component : cones) {
    const ReferenceSkeleton skeleton(component);
    for (int i = 0; i < 300; ++i) {
      const scene::Vec3 p = random.in_ball(3);
      const Interval q = skeleton.at(interval_of(p)).q;
      ASSERT_CLOSE(q.middle() / brute_force_q(component, exactly(p)), 1, 1e-15L) << p.x << " " << p.y << " " << p.z;
      ASSERT_LT(q.width(), 1e-14L * q.hi);
    }
  }
}

/// q of p against `brute_force` and the eikonal equation |∇q|² = 4q/r², which every distance obeys.
template <class BruteForce>
void expect_distance(const ReferenceSkeleton& skeleton, long double radius, const Vector<long double>& p,
                     const BruteForce& brute_force) {
  const RelativeDistance here = skeleton.at({p.x, p.y, p.z});
  const long double expected = brute_force(p) / (radius * radius);
  ASSERT_CLOSE(here.q.middle(), expected, 1e-15L * expected + 1e-18L);
  // The splinter's normal costs two digits.
  ASSERT_LT(here.q.width(), 1e-13L * here.q.hi + 1e-30L);
  const Interval eikonal = squared_length(here.gradient) * square(Interval(radius)) * Interval(0.25L);
  ASSERT_CLOSE(eikonal.middle(), here.q.middle(), 1e-14L * here.q.middle() + 1e-30L);
}

TEST(ReferenceField, BoxIsTheNearestOfItsPoints) {
  const std::vector<scene::Component> boxes = {box({-0.5, -0.2, -1}, {0.7, 0.9, 1.5}, 0.3),
                                               box({-1, 0.25, -1}, {1, 0.25, 0.5}, 0.1),  // no thickness
                                               box({0.5, 0.5, -1}, {0.5, 0.5, 1}, 0.1),   // a segment in disguise
                                               box({1, 0, 0}, {1, 0, 0}, 0.2)};           // a point
  RandomSource random(16);
  for (const scene::Component& component : boxes) {
    const auto brute_force = [&](const Vector<long double>& p) {
      const auto along_axis = [](long double x, long double low, long double high) {
        return ternary_minimum([&](long double c) { return (x - c) * (x - c); }, low, high);
      };
      return along_axis(p.x, component.a.x, component.b.x) + along_axis(p.y, component.a.y, component.b.y) +
             along_axis(p.z, component.a.z, component.b.z);
    };
    const ReferenceSkeleton skeleton(component);
    for (int i = 0; i < 300; ++i)
      expect_distance(skeleton, component.radius_a, exactly(random.in_ball(3)), brute_force);
  }
  const ReferenceSkeleton solid(boxes[0]);
  EXPECT_EQ(solid.at(interval_of({0.1, 0.3, 0.2})).q.hi, 0);
  EXPECT_EQ(squared_length(solid.at(interval_of({0.1, 0.3, 0.2})).gradient).hi, 0);
}

TEST(ReferenceField, TriangleIsTheNearestOfItsPoints) {
  struct Triangle {
    scene::Vec3 a, b, c;
  };
  const std::vector<Triangle> triangles = {{{0, 0, 0}, {1.3, 0.2, -0.1}, {0.4, 0.9, 0.6}},  // scalene
                                           {{-1, 0, 0}, {1, 0, 0}, {-1, 1, 0}},             // right-angled
                                           {{0, 0, 0}, {2, 0.1, 0}, {-0.9, 0.3, 0.1}},      // obtuse
                                           {{-1, -0.3, 0.2}, {1, 0.4, 0}, {1, 0.4, 1e-3}},  // a needle
                                           {{-1, 0, 0}, {1, 0, 0}, {0.1, 1e-4, 0.5e-4}}};   // a splinter
  RandomSource random(17);
  for (const auto& [a, b, c] : triangles) {
    const Vector<long double> start = exactly(a), along = exactly(b) - start, across = exactly(c) - start;
    const auto brute_force = [&](const Vector<long double>& p) {
      const auto nearest_in_row = [&](long double u) {
        const Vector<long double> w = p - start - along * u;
        return ternary_minimum([&](long double v) { return squared_length(w - across * v); }, 0, 1 - u);
      };
      return ternary_minimum(nearest_in_row, 0, 1);
    };
    const std::vector<scene::Vec3> corners = {{9, 9, 9}, c};
    scene::Component component = triangle(a, b, 0.2);
    component.corner = 1;
    const ReferenceSkeleton skeleton(component, corners);
    for (int i = 0; i < 50; ++i) expect_distance(skeleton, 0.2, exactly(random.in_ball(2.5)), brute_force);
    // Over and next to the face, where the other points seldom are.
    for (int i = 0; i < 50; ++i) {
      const long double u = random.between(-0.1, 1.1), v = random.between(-0.1, 1.1 - static_cast<double>(u));
      const Vector<long double> lift = exactly(random.in_ball(0.3));
      expect_distance(skeleton, 0.2, start + along * u + across * v + lift, brute_force);
    }
  }
}

TEST(ReferenceField, CircleIsTheNearestOfItsPoints) {
  RandomSource random(18);
  for (const scene::Vec3& axis : {scene::Vec3(0, 1, 0), scene::Vec3(0.36, 0.48, 0.8), random.direction()}) {
    const scene::Component component = circle({0.1, -0.2, 0.3}, axis, 1.2, 0.3);
    const scene::Vec3 side = axis.cross(random.direction()).normalized();
    const Vector<long double> x = exactly(side), y = cross(exactly(axis), x);
    const auto brute_force = [&](const Vector<long double>& p) {
      const auto at_angle = [&](long double angle) {
        const Vector<long double> towards = x * std::cos(angle) + y * std::sin(angle);
        return squared_length(p - exactly(component.a) - towards * 1.2L);
      };
      return stretchwise_minimum(at_angle, 0, 6.3L);
    };
    const ReferenceSkeleton skeleton(component);
    for (int i = 0; i < 100; ++i) {
      const Vector<long double> p = exactly(random.in_ball(3));
      const RelativeDistance here = skeleton.at({p.x, p.y, p.z});
      const long double expected = brute_force(p) / square(Interval(0.3)).middle();
      // x and y are of unit length to 1e-16 only.
      ASSERT_CLOSE(here.q.middle(), expected, 1e-14L * (1 + expected));
      ASSERT_LT(here.q.width(), 1e-14L * (1 + here.q.hi));
      const Interval eikonal = squared_length(here.gradient) * square(Interval(0.3)) * Interval(0.25L);
      ASSERT_CLOSE(eikonal.middle(), here.q.middle(), 1e-14L * (1 + here.q.middle()));
    }
    const Interval on_axis = skeleton.at(interval_of(component.a)).q;
    EXPECT_CLOSE(on_axis.middle(), 1.2L * 1.2L / (0.3L * 0.3L), 1e-14L);
  }
}

TEST(ReferenceField, LinesAcrossACirclesAxisAreEnclosed) {
  const scene::Component component = circle({0, 0, 0}, {0, 1, 0}, 1, 0.5);
  const ReferenceSkeleton skeleton(component);
  RandomSource random(19);
  for (int i = 0; i < 50; ++i) {
    // Through the axis itself, and just past it.
    const scene::Vec3 middle(i % 2 == 0 ? 0 : 1e-6 * random.unit(), random.between(-1, 1), 0);
    const Line line{interval_of(middle), interval_of(random.direction())};
    const long double t0 = -random.unit(), t1 = random.unit();
    const DistanceOnLine range = skeleton.over({line, t0, t1, skeleton.at(line, t0), skeleton.at(line, t1)});
    EXPECT_LT(range.q.hi, 40);  // the most there is: at two from the circle, where q = 16, and the steps' slack
    for (int k = 0; k <= 200; ++k) {
      const DistanceOnLine here = skeleton.at(line, t0 + (t1 - t0) * k / 200);
      ASSERT_LE(range.q.lo, here.q.hi);
      ASSERT_GE(range.q.hi, here.q.lo);
      if (here.slope.width() > 1) continue;  // on the axis: any of its slopes
      ASSERT_LE(range.slope.lo, here.slope.hi);
      ASSERT_GE(range.slope.hi, here.slope.lo);
    }
  }
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
      ASSERT_TRUE(range.contains(value)) << value << " not in [" << range.lo << ", " << range.hi << "]";
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
    if (on_ray.all().empty()) continue;
    const long double t0 = on_ray.begin() + (on_ray.end() - on_ray.begin()) * static_cast<long double>(random.unit());
    long double coarse = 0;
    for (const long double width : {0.1L, 0.01L, 0.001L, 0.0001L}) {
      const FieldRange range = on_ray.over(on_ray.all(), t0, t0 + width);
      Interval sampled = on_ray.at(on_ray.all(), t0).value;
      for (int k = 0; k <= 50; ++k) {
        const long double t = std::min(t0 + width * k / 50, t0 + width);
        const FieldRange here = on_ray.at(on_ray.all(), t);
        const FieldSample sample = field.sample(along(line, t));
        ASSERT_CLOSE(sample.value, here.value.middle(), 1e-16L * (sample.sum_of_values + 1));
        ASSERT_LE(range.value.lo, here.value.hi);
        ASSERT_GE(range.value.hi, here.value.lo);
        ASSERT_LE(range.derivative.lo, here.derivative.hi);
        ASSERT_GE(range.derivative.hi, here.derivative.lo);
        sampled = hull(sampled, here.value);
      }
      coarse = range.value.width() - sampled.width();
      ++checked;
    }
    const long double size = on_ray.magnitude_at(t0).values + on_ray.magnitude_at(t0).derivatives + 1;
    // 1e-4 wide: an enclosure of first order would be off by about 1e-4 of the derivative's size. Cones' kinks and thin
    // components leave a factor in front of the square.
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
