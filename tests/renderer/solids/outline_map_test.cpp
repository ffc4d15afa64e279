// The map of an outline against its curves: what it says of rectangles must hold at every point of them.
#include "renderer/solids/outline_map.h"

#include "renderer/solids/outline.h"
#include "tests/renderer/solids/random_outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render::test {
namespace {

using Side = OutlineMap::Side;

Side side_at(const PreparedOutline& outline, const PlanePoint& point) {
  return contains(outline, point) ? Side::inside : Side::outside;
}

TEST(OutlineMap, knows_the_side_of_every_point_of_a_rectangle_that_it_names) {
  int known[3] = {};
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Outline outline = random_outline(random);
    // Far from the origin, or much wider than high.
    const double moved = random.uniform(0, 1) < 0.3 ? 1e5 : 0, wide = random.uniform(0, 1) < 0.3 ? 1e3 : 1;
    for (PlanePoint& p : outline.points) p = {wide * p.u + moved, p.v - moved};
    const PreparedOutline prepared = prepare(outline);
    for (int i = 0; i < 200; ++i) {
      const PlanePoint from{moved + wide * random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2) - moved};
      const double size = std::exp2(-random.uniform(1, 9));
      const PlanePoint to{from.u + wide * size * random.uniform(0, 1), from.v + size * random.uniform(0, 1)};
      const Side side = prepared.map.side_of(from, to);
      ++known[static_cast<int>(side)];
      if (side == Side::mixed) continue;
      for (int k = 0; k < 4; ++k) {
        const PlanePoint point{random.uniform(from.u, to.u), random.uniform(from.v, to.v)};
        ASSERT_EQ(side_at(prepared, point), side) << "seed " << seed << " at " << point.u << ' ' << point.v;
      }
    }
  }
  EXPECT_GT(known[static_cast<int>(Side::outside)], 10000);
  EXPECT_GT(known[static_cast<int>(Side::inside)], 1000);
}

TEST(OutlineMap, knows_nothing_of_what_is_no_rectangle) {
  Random random(1);
  const PreparedOutline outline = prepare(random_outline(random));
  EXPECT_EQ(outline.map.side_of({NAN, 0}, {NAN, 0}), Side::mixed);
  EXPECT_EQ(outline.map.side_of({-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}), Side::mixed);
  EXPECT_EQ(outline.map.side_of({5, 0}, {HUGE_VAL, HUGE_VAL}), Side::outside);
}

TEST(OutlineMap, of_curves_on_a_line_or_far_from_the_origin_is_empty) {
  Outline line;
  add_contour(line, {{0, 1}, {2, 1}}, {1, 1});
  EXPECT_TRUE(prepare(line).map.sides.empty());
  Outline far;
  add_contour(far, {{1e12, 0}, {1e12 + 1, 0}, {1e12, 1}}, {1, 1, 1});
  EXPECT_TRUE(prepare(far).map.sides.empty());
}

}  // namespace
}  // namespace isl::render::test
