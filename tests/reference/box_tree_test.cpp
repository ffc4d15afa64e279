// The tree of boxes leaves out nothing that a line meets, however large, small or far the boxes are.
#include "renderer/reference/box_tree.h"

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

std::vector<std::uint32_t> along(const BoxTree& tree, const LineOfSight& line) {
  std::vector<std::uint32_t> numbers;
  tree.along(rough(line), numbers);
  return numbers;
}

Box box_at(const scene::Vec3& centre, const scene::Vec3& half) {
  const scene::Vec3 low = centre - half, high = centre + half;
  return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

/// True if the half-line meets the box, grown by `slack`: in extended precision, side by side.
bool meets(const Box& box, const LineOfSight& line, long double slack) {
  long double begin = 0, end = std::numeric_limits<long double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const long double o = line.origin[i], d = line.direction[i], low = box.low[k] - slack, high = box.high[k] + slack;
    if (d == 0) {
      if (o < low || o > high) return false;
      continue;
    }
    begin = std::max(begin, std::min((low - o) / d, (high - o) / d));
    end = std::min(end, std::max((low - o) / d, (high - o) / d));
  }
  return begin <= end;
}

TEST(BoxTrees, FindEveryBoxOnALineAndNoOther) {
  RandomSource random(1);
  for (const int count : {1, 2, 3, 9, 1000}) {
    std::vector<Box> boxes;
    const auto size = [&] { return std::pow(10, random.between(-12, 3)); };
    for (int i = 0; i < count; ++i)
      boxes.push_back(box_at(random.in_ball(std::pow(10, random.between(-6, 6))), {size(), size(), size()}));
    const BoxTree tree(boxes);
    std::size_t met = 0;
    for (int k = 0; k < 200; ++k) {
      // Half of the lines go through a corner of a box or just beside it, some of them along an axis.
      LineOfSight line = random_line(random, 1e6, 10);
      if (k % 2 == 0) {
        const Box& box = boxes[static_cast<std::size_t>(random.below(count))];
        if (k % 8 == 0) line.direction = scene::Vec3(0, 0, 1);
        line.origin = scene::Vec3(box.low[0], box.high[1], box.low[2]) - line.direction * random.between(0, 1e6);
      }
      const std::vector<std::uint32_t> numbers = along(tree, line);
      EXPECT_TRUE(std::ranges::is_sorted(numbers));
      // From 10⁶ away, a line is known to some 10⁻⁹.
      for (const std::uint32_t i : numbers) EXPECT_TRUE(meets(boxes[i], line, 1e-8L)) << "box " << i << " of " << count;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (!meets(boxes[i], line, 0)) continue;
        ++met;
        EXPECT_TRUE(std::ranges::binary_search(numbers, i)) << "box " << i << " of " << count;
      }
    }
    EXPECT_GT(met, 0u);
  }
}

TEST(BoxTrees, AlwaysFindWhatHasNoEnd) {
  const Box unit = box_at({0, 0, 0}, {1, 1, 1}), beside = box_at({9, 0, 0}, {1, 1, 1});
  const BoxTree tree({unit, Box::everything(), beside});
  EXPECT_EQ(along(tree, {{0, 5, -5}, {0, 0, 1}}), std::vector<std::uint32_t>{1});
  EXPECT_EQ(along(tree, {{0, 0.5, -5}, {0, 0, 1}}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(along(tree, {{0, 0.5, 5}, {0, 0, 1}}), std::vector<std::uint32_t>{1}) << "behind the line's origin";
  EXPECT_FALSE(tree.bounds().is_bounded());
  EXPECT_TRUE(BoxTree().bounds().is_empty());
  EXPECT_TRUE(box_before(BoxTree().bounds(), scene::Matrix()).is_empty());
}

TEST(RoughLines, ComeNoEarlierThanTheyAreTold) {
  const RoughLine line = rough({{0, 0, -10}, {0, 0, 2}});
  const RoughLine::Stretch ahead = line.within(box_at({0, 0, 0}, {4, 4, 4}));
  EXPECT_NEAR(ahead.begin, 3, 1e-12);
  EXPECT_LE(ahead.begin, 3);
  EXPECT_NEAR(ahead.end, 7, 1e-12);
  EXPECT_GE(ahead.end, 7);
  EXPECT_EQ(line.within(box_at({0, 0, 0}, {11, 11, 11})).begin, 0);
}

TEST(BoxesBeforeAMap, HoldAllThatItTakesIntoTheBall) {
  RandomSource random(2);
  for (int k = 0; k < 100; ++k) {
    scene::Transform map = random_transform(random, std::pow(10, random.between(-3, 9)));
    scene::Matrix stretch;
    stretch.setScale(scene::Vec3(std::pow(10, random.between(-6, 6)), 1, std::pow(10, random.between(-6, 6))));
    const scene::Matrix m = map.matrix * stretch;
    const scene::Vec3 centre = random.in_ball(5);
    const Box box = box_before(exactly(centre), 1, m);
    if (!box.is_bounded()) continue;
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
      const long double p[3] = {dot(q, cross(row(1), row(2))) / all, dot(q, cross(row(2), row(0))) / all,
                                dot(q, cross(row(0), row(1))) / all};
      for (std::size_t j = 0; j < 3; ++j) {
        const long double slack = 1e-12L * (static_cast<long double>(box.high[j]) - box.low[j]);
        EXPECT_GE(p[j], box.low[j] - slack) << k;
        EXPECT_LE(p[j], box.high[j] + slack) << k;
      }
    }
  }
  scene::Matrix flat;
  flat[1][1] = 0;
  EXPECT_FALSE(box_before({0, 0, 0}, 1, flat).is_bounded()) << "a map without an inverse";
}

}  // namespace
}  // namespace isl::reference
