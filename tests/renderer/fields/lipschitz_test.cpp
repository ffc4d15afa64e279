// Lipschitz bounds of fields over boxes, compared with the fields' values at points in them.
#include "renderer/fields/lipschitz.h"
#include "tests/reference/random_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render {
namespace {

TEST(LipschitzRange, HoldsTheFieldThroughoutABox) {
  reference::RandomSource random(91);
  int reached = 0, missed = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const scene::Database database = reference::random_blob(random, {.components = 12, .scale = 1, .hardest = 60});
    const ComponentTable table = compile_components(database, database.blobs[0]);
    for (int i = 0; i < 200; ++i) {
      const Vec3 middle = random.in_ball(1.5), half(std::exp2(random.between(-8, 0)));
      const Box box(middle - half, middle + half);
      const auto item = static_cast<std::uint32_t>(random.below(static_cast<int>(table.size())));
      const FieldGroup& group = table.group_of(item);
      const FieldRange bound = lipschitz_range(table, group, item, box);
      (bound.low == 0 && bound.high == 0 ? missed : reached) += 1;
      for (int k = 0; k < 20; ++k) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
          p[axis] = middle[axis] + half[axis] * (k < 8 ? ((k >> axis) & 1 ? 1 : -1) : random.between(-1, 1));
        const FieldRange value = field_range(table, group, item, Box(p, p));
        const double rounding = 1e-12 * (std::abs(bound.low) + std::abs(bound.high));
        ASSERT_LE(bound.low - rounding, value.high) << "scene " << scene << ", item " << item;
        ASSERT_GE(bound.high + rounding, value.low) << "scene " << scene << ", item " << item;
      }
    }
  }
  EXPECT_GT(reached, 1000);
  EXPECT_GT(missed, 1000);
}

TEST(LipschitzRange, IsTheValueInABoxOfNoSize) {
  reference::RandomSource random(92);
  const scene::Database database = reference::random_blob(random, {.components = 40, .scale = 1, .hardest = 8});
  const ComponentTable table = compile_components(database, database.blobs[0]);
  for (std::uint32_t item = 0; item < table.size(); ++item) {
    const FieldGroup& group = table.group_of(item);
    const Vec3 p = support_bounds(table, group, item).center();
    if (!std::isfinite(p.x + p.y + p.z)) continue;
    const FieldRange bound = lipschitz_range(table, group, item, Box(p, p));
    EXPECT_EQ(bound.low, bound.high) << item;
  }
}

}  // namespace
}  // namespace isl::render
