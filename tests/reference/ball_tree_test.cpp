// The tree of balls leaves out nothing that a line meets, however large, small or far the balls are.
#include "renderer/reference/ball_tree.h"

#include "renderer/reference/reference_skeleton.h"
#include "tests/reference/random_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace isl::reference {
namespace {

RoughLine rough(const LineOfSight& line) { return RoughLine({interval_of(line.origin), interval_of(line.direction)}); }

std::vector<std::uint32_t> along(const BallTree& tree, const LineOfSight& line) {
  std::vector<std::uint32_t> numbers;
  tree.along(rough(line), numbers);
  return numbers;
}

/// The distance of a ball's centre from a line, over its radius; in extended precision.
long double relative_distance(const Ball& ball, const LineOfSight& line) {
  const Vector<long double> w{static_cast<long double>(ball.x) - line.origin.x,
                              static_cast<long double>(ball.y) - line.origin.y,
                              static_cast<long double>(ball.z) - line.origin.z};
  const Vector<long double> d = exactly(line.direction);
  return std::sqrt(squared_length(cross(w, d)) / squared_length(d)) / ball.radius;
}

TEST(BallTrees, FindEveryBallOnALineAndNoOther) {
  RandomSource random(1);
  for (const int count : {1, 7, 8, 9, 1000}) {
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i) {
      const scene::Vec3 at = random.in_ball(std::pow(10, random.between(-6, 6)));
      balls.push_back({at.x, at.y, at.z, std::pow(10, random.between(-12, 3))});
    }
    const BallTree tree(balls);
    std::size_t met = 0;
    for (int k = 0; k < 200; ++k) {
      // Half of the lines touch a ball from inside, to a few roundings.
      LineOfSight line = random_line(random, 1e6, 10);
      if (k % 2 == 0) {
        const Ball& ball = balls[static_cast<std::size_t>(random.below(count))];
        line.origin = scene::Vec3(ball.x, ball.y, ball.z) +
                      line.direction.cross(random.direction()).normalized() * ball.radius * (1 - 1e-15) -
                      line.direction * random.between(0, 1e6);
      }
      const std::vector<std::uint32_t> numbers = along(tree, line);
      EXPECT_TRUE(std::ranges::is_sorted(numbers));
      // From 10⁶ away, a line is known to some 10⁻⁹.
      for (const std::uint32_t i : numbers) EXPECT_LE((relative_distance(balls[i], line) - 1) * balls[i].radius, 1e-8);
      for (std::uint32_t i = 0; i < balls.size(); ++i) {
        if (relative_distance(balls[i], line) > 1) continue;
        ++met;
        EXPECT_TRUE(std::ranges::binary_search(numbers, i)) << "ball " << i << " of " << count;
      }
    }
    EXPECT_GT(met, 0u);
  }
}

TEST(BallTrees, AlwaysFindWhatHasNoEnd) {
  const double infinite = std::numeric_limits<double>::infinity();
  const BallTree tree({{0, 0, 0, 1}, {0, 0, 0, infinite}, {9, 0, 0, 1}});
  EXPECT_EQ(along(tree, {{0, 5, -5}, {0, 0, 1}}), std::vector<std::uint32_t>{1});
  EXPECT_EQ(along(tree, {{0, 0.5, -5}, {0, 0, 1}}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(std::isinf(tree.bounds().radius));
  EXPECT_LT(BallTree().bounds().radius, 0);
}

TEST(RoughLines, ComeNoEarlierThanTheyAreTold) {
  const RoughLine line = rough({{0, 0, -10}, {0, 0, 2}});
  EXPECT_NEAR(line.earliest({0, 0, 0, 4}), 3, 1e-12);
  EXPECT_LE(line.earliest({0, 0, 0, 4}), 3);
  EXPECT_EQ(line.earliest({0, 0, 0, 11}), 0);
}

TEST(BallsBeforeAMap, HoldAllThatItTakesIntoTheBall) {
  RandomSource random(2);
  for (int k = 0; k < 100; ++k) {
    scene::Transform map = random_transform(random, std::pow(10, random.between(-3, 9)));
    scene::Matrix stretch;
    stretch.setScale(scene::Vec3(std::pow(10, random.between(-6, 6)), 1, std::pow(10, random.between(-6, 6))));
    const scene::Matrix m = map.matrix * stretch;
    const scene::Vec3 centre = random.in_ball(5);
    const Ball ball = ball_before(exactly(centre), 1, m);
    if (std::isinf(ball.radius)) continue;
    // Points of the sphere are taken back in extended precision, by Cramer's rule.
    for (int i = 0; i < 20; ++i) {
      const scene::Vec3 rim = random.direction();
      const Vector<long double> q{static_cast<long double>(centre.x) + rim.x - m[3][0],
                                  static_cast<long double>(centre.y) + rim.y - m[3][1],
                                  static_cast<long double>(centre.z) + rim.z - m[3][2]};
      const auto row = [&](int r) {
        return Vector<long double>{static_cast<long double>(m[r][0]), static_cast<long double>(m[r][1]),
                                   static_cast<long double>(m[r][2])};
      };
      const long double all = dot(row(0), cross(row(1), row(2)));
      const Vector<long double> p{dot(q, cross(row(1), row(2))) / all, dot(q, cross(row(2), row(0))) / all,
                                  dot(q, cross(row(0), row(1))) / all};
      const Vector<long double> off{p.x - ball.x, p.y - ball.y, p.z - ball.z};
      EXPECT_LE(std::sqrt(squared_length(off)), ball.radius * (1 + 1e-12L)) << k;
    }
  }
  scene::Matrix flat;
  flat[1][1] = 0;
  EXPECT_TRUE(std::isinf(ball_before({0, 0, 0}, 1, flat).radius)) << "a map without an inverse";
}

}  // namespace
}  // namespace isl::reference
