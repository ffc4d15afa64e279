// The reference's distances, compared with minimising over the skeleton by brute force.
#include "renderer/reference/reference_skeleton.h"

#include "tests/reference/near.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace isl::reference {
namespace {

struct RelativeDistance {
  Interval q;
  Vector<Interval> gradient;
};

/// q and ∇q at a place: the slopes along the axes.
RelativeDistance distance_at(const ReferenceSkeleton& skeleton, const Vector<Interval>& p) {
  const auto along = [&](const Vector<Interval>& direction) { return skeleton.of(Line{p, direction}.at(0)); };
  const Jet x = along({1, 0, 0}), y = along({0, 1, 0}), z = along({0, 0, 1});
  return {x.value, {x.slope, y.slope, z.slope}};
}

/// The least value of f on [low, high] by ternary search. Precondition: f falls and then rises. (2/3)⁶⁰ = 3e-11 of a
/// place is 1e-21 of a value.
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

/// The least value found by ternary search in each of 64 stretches.
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

TEST(ReferenceSkeleton, ConeIsTheNearestOfAllItsSpheres) {
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
      const Interval q = distance_at(skeleton, interval_of(p)).q;
      ASSERT_CLOSE(q.middle() / brute_force_q(component, exactly(p)), 1, 1e-15L) << p.x << " " << p.y << " " << p.z;
      ASSERT_LT(q.width(), 1e-14L * q.hi());
    }
  }
}

/// Compares q of p with `brute_force` and with the eikonal equation |∇q|² = 4q/r², which every distance obeys.
template <class BruteForce>
void expect_distance(const ReferenceSkeleton& skeleton, long double radius, const Vector<long double>& p,
                     const BruteForce& brute_force) {
  const RelativeDistance here = distance_at(skeleton, {p.x, p.y, p.z});
  const long double expected = brute_force(p) / (radius * radius);
  ASSERT_CLOSE(here.q.middle(), expected, 1e-15L * expected + 1e-18L);
  // The normal of a splinter costs two digits.
  ASSERT_LT(here.q.width(), 1e-13L * here.q.hi() + 1e-30L);
  const Interval eikonal = squared_length(here.gradient) * square(Interval(radius)) * Interval(0.25L);
  ASSERT_CLOSE(eikonal.middle(), here.q.middle(), 1e-14L * here.q.middle() + 1e-30L);
}

TEST(ReferenceSkeleton, BoxIsTheNearestOfItsPoints) {
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
  EXPECT_EQ(distance_at(solid, interval_of({0.1, 0.3, 0.2})).q.hi(), 0);
  EXPECT_EQ(squared_length(distance_at(solid, interval_of({0.1, 0.3, 0.2})).gradient).hi(), 0);
}

TEST(ReferenceSkeleton, TriangleIsTheNearestOfItsPoints) {
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
    // Points over and next to the face, which the other points seldom are.
    for (int i = 0; i < 50; ++i) {
      const long double u = random.between(-0.1, 1.1), v = random.between(-0.1, 1.1 - static_cast<double>(u));
      const Vector<long double> lift = exactly(random.in_ball(0.3));
      expect_distance(skeleton, 0.2, start + along * u + across * v + lift, brute_force);
    }
  }
}

TEST(ReferenceSkeleton, CircleIsTheNearestOfItsPoints) {
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
      const RelativeDistance here = distance_at(skeleton, {p.x, p.y, p.z});
      const long double expected = brute_force(p) / square(Interval(0.3)).middle();
      // x and y have unit length only to 1e-16.
      ASSERT_CLOSE(here.q.middle(), expected, 1e-14L * (1 + expected));
      ASSERT_LT(here.q.width(), 1e-14L * (1 + here.q.hi()));
      const Interval eikonal = squared_length(here.gradient) * square(Interval(0.3)) * Interval(0.25L);
      ASSERT_CLOSE(eikonal.middle(), here.q.middle(), 1e-14L * (1 + here.q.middle()));
    }
    const Interval on_axis = distance_at(skeleton, interval_of(component.a)).q;
    EXPECT_CLOSE(on_axis.middle(), 1.2L * 1.2L / (0.3L * 0.3L), 1e-14L);
  }
}

TEST(ReferenceSkeleton, DiscIsTheNearestOfItsCircles) {
  RandomSource random(20);
  for (const scene::Vec3& axis : {scene::Vec3(0, 1, 0), scene::Vec3(0.36, 0.48, 0.8), random.direction()}) {
    const scene::Component component = disc({0.1, -0.2, 0.3}, axis, 1.2, 0.3);
    const Vector<long double> centre = exactly(component.a), up = exactly(axis);
    const ReferenceSkeleton skeleton(component);
    for (int i = 0; i < 100; ++i) {
      const Vector<long double> p = exactly(random.in_ball(3));
      // In the half-plane of p the circles that the disc is made of are points at 0 … 1.2 from the centre.
      const Vector<long double> w = p - centre, across = w - up * dot(w, up);
      const Vector<long double> towards = across * (1 / std::sqrt(squared_length(across)));
      const auto at_radius = [&](long double radius) { return squared_length(w - towards * radius); };
      const long double expected = stretchwise_minimum(at_radius, 0, 1.2L) / square(Interval(0.3)).middle();
      const RelativeDistance here = distance_at(skeleton, {p.x, p.y, p.z});
      // The axis is of unit length to 1e-16 only.
      ASSERT_CLOSE(here.q.middle(), expected, 1e-14L * (1 + expected));
      ASSERT_LT(here.q.width(), 1e-14L * (1 + here.q.hi()));
      const Interval eikonal = squared_length(here.gradient) * square(Interval(0.3)) * Interval(0.25L);
      ASSERT_CLOSE(eikonal.middle(), here.q.middle(), 1e-14L * (1 + here.q.middle()));
    }
  }
}

TEST(ReferenceSkeleton, LinesAcrossACirclesAxisAreEnclosed) {
  const scene::Component component = circle({0, 0, 0}, {0, 1, 0}, 1, 0.5);
  const ReferenceSkeleton skeleton(component);
  RandomSource random(19);
  for (int i = 0; i < 50; ++i) {
    // Lines through the axis itself, and just past it.
    const scene::Vec3 middle(i % 2 == 0 ? 0 : 1e-6 * random.unit(), random.between(-1, 1), 0);
    const Line line{interval_of(middle), interval_of(random.direction())};
    const long double t0 = -random.unit(), t1 = random.unit();
    const Interval whole(t0, t1);
    const Jet range = sharpened(skeleton.of(line.at(whole)), skeleton.of(line.at(whole.middle())), whole.radius());
    EXPECT_LT(range.value.hi(), 40);  // the greatest value: at the distance 2 from the circle q = 16
    for (int k = 0; k <= 200; ++k) {
      const Jet here = skeleton.of(line.at(std::min(t0 + (t1 - t0) * k / 200, t1)));
      ASSERT_LE(range.value.lo(), here.value.hi());
      ASSERT_GE(range.value.hi(), here.value.lo());
      if (here.slope.width() > 1) continue;  // on the axis any of its slopes is right
      ASSERT_LE(range.slope.lo(), here.slope.hi());
      ASSERT_GE(range.slope.hi(), here.slope.lo());
    }
  }
}

}  // namespace
}  // namespace isl::reference
