// A search that ends early, with the first crossing or at some t, finds the same ones, to the last bit, as the search
// for all.
#include "tests/renderer/solids/membership.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace isl::render {
namespace {

using scene::SolidKind;
using test::Random;

std::size_t first_ahead(const Crossings& found) {
  std::size_t first = 0;
  while (first < static_cast<std::size_t>(found.count) && !(found.t[first] > 0)) ++first;
  return first;
}

class CrossingsToFirst : public testing::TestWithParam<SolidKind> {};

TEST_P(CrossingsToFirst, FindTheSameFirstOne) {
  Random random(31);
  int met = 0, left_out = 0;
  for (int i = 0; i < 20000; ++i) {
    const test::WholeSolid whole = test::random_whole(random, GetParam());
    const Vec3 origin = random.in_cube(2), direction = random.direction() * random.uniform(0.1, 3);
    Vec3 from = origin;
    std::uint32_t part = kNoPart;
    for (int start = 0; start < 2; ++start) {
      const Crossings all = crossings(whole.solid, from, direction, part, whole.details);
      const Crossings some = crossings_to_first(whole.solid, from, direction, part, whole.details);
      const std::size_t first = first_ahead(all), same = first_ahead(some);
      ASSERT_EQ(first == static_cast<std::size_t>(all.count), same == static_cast<std::size_t>(some.count)) << i;
      if (first == static_cast<std::size_t>(all.count)) break;
      ASSERT_EQ(all.t[first], some.t[same]) << i;
      ASSERT_EQ(all.part[first], some.part[same]) << i;
      ++met;
      if (some.count < all.count) ++left_out;
      from = from + direction * all.t[first];  // once more, from the surface
      part = all.part[first];
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(left_out, 500);
}

INSTANTIATE_TEST_SUITE_P(SolidsThatTakeLong, CrossingsToFirst,
                         testing::Values(SolidKind::torus, SolidKind::superellipsoid, SolidKind::ovus,
                                         SolidKind::quartic, SolidKind::poly));

class CrossingsUpTo : public testing::TestWithParam<SolidKind> {};

TEST_P(CrossingsUpTo, AreTheSameUpToThere) {
  Random random(32);
  int same = 0, left_out = 0;
  for (int i = 0; i < 20000; ++i) {
    const test::WholeSolid whole = test::random_whole(random, GetParam());
    const Vec3 origin = random.in_cube(2), direction = random.direction() * random.uniform(0.1, 3);
    Stretch stretch;
    if (random.uniform(0, 2) < 1) stretch.to = random.uniform(1, 8);
    const Crossings all = boundary(whole.solid, origin, direction, kNoPart, whole.details, stretch);
    stretch.wanted_to = random.uniform(0, 4);
    const Crossings some = boundary(whole.solid, origin, direction, kNoPart, whole.details, stretch);
    for (int k = 0; k < all.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (!(all.t[at] < stretch.wanted_to)) break;
      ASSERT_LT(k, some.count) << i;
      ASSERT_EQ(all.t[at], some.t[at]) << i;
      ++same;
    }
    // Each crossing changes the side, so both tell the same of the beginning.
    ASSERT_EQ(all.ends_inside != (all.count % 2 == 1), some.ends_inside != (some.count % 2 == 1)) << i;
    if (some.count < all.count) ++left_out;
  }
  EXPECT_GT(same, 1000);
  EXPECT_GT(left_out, 500);
}

INSTANTIATE_TEST_SUITE_P(Polynomials, CrossingsUpTo,
                         testing::Values(SolidKind::cubic, SolidKind::quartic, SolidKind::poly));

}  // namespace
}  // namespace isl::render
