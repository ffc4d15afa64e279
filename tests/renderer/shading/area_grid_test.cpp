// The points of area lights, and their weights.
#include "renderer/shading/area_grid.h"

#include <gmock/gmock.h>

#include <numeric>

namespace isl::render::test {
namespace {

using scene::AreaLight;
using testing::ElementsAre;

TEST(AreaGrid, weighs_powers_of_two_evenly_and_one_more_by_the_trapezoid_rule) {
  EXPECT_THAT(area_weights(1), ElementsAre(1));
  EXPECT_THAT(area_weights(2), ElementsAre(.5, .5));
  EXPECT_THAT(area_weights(4), ElementsAre(.25, .25, .25, .25));
  EXPECT_THAT(area_weights(5), ElementsAre(.125, .25, .25, .25, .125));
  // The halves have 0 1 2 3 and 3 4 5 6.
  EXPECT_THAT(area_weights(7), ElementsAre(.125, .125, .125, .25, .125, .125, .125));
}

TEST(AreaGrid, weights_add_up_to_one_and_are_the_same_from_both_ends) {
  for (int count = 1; count <= 100; ++count) {
    const std::vector<double> weights = area_weights(count);
    EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0.0), 1) << count;
    EXPECT_TRUE(std::equal(weights.begin(), weights.end(), weights.rbegin())) << count;
    for (const double weight : weights) EXPECT_GT(weight, 0) << count;
  }
}

TEST(AreaGrid, quarters_cover_a_part_and_share_the_middle_if_there_is_one) {
  const AreaPart odd{0, 0, 4, 5};
  EXPECT_TRUE(odd.can_be_divided());
  const AreaPart first = odd.quarter(0), last = odd.quarter(3);
  EXPECT_EQ(first.u2, 2);
  EXPECT_EQ(last.u1, 2);
  EXPECT_EQ(first.v2, 2);
  EXPECT_EQ(last.v1, 3);
  EXPECT_EQ(odd.quarter(1).u1, 2);
  EXPECT_EQ(odd.quarter(1).v2, 2);
  EXPECT_FALSE((AreaPart{3, 0, 4, 1}.can_be_divided()));
}

TEST(AreaGrid, reaches_from_edge_to_edge) {
  AreaLight area{.edge_a = {2, 0, 0}, .edge_b = {0, 0, 4}, .count_a = 3, .count_b = 5};
  const AreaEdges edges = edges_of(area, {0, 1, 0});
  EXPECT_EQ(area_offset(area, edges, 0, 0), Vec3(-1, 0, -2));
  EXPECT_EQ(area_offset(area, edges, 1, 2), Vec3(0, 0, 0));
  EXPECT_EQ(area_offset(area, edges, 2, 4), Vec3(1, 0, 2));
  area.count_b = 1;
  EXPECT_EQ(area_offset(area, edges, 2, 0), Vec3(1, 0, 0)) << "a single row is in the middle";
}

TEST(AreaGrid, that_is_circular_lies_in_an_ellipse) {
  const AreaLight area{.edge_a = {2, 0, 0}, .edge_b = {0, 0, 4}, .count_a = 6, .count_b = 7, .circular = true};
  const AreaEdges edges = edges_of(area, {0, 1, 0});
  for (int u = 0; u < area.count_a; ++u) {
    for (int v = 0; v < area.count_b; ++v) {
      const Vec3 offset = area_offset(area, edges, u, v);
      EXPECT_LE(std::hypot(offset.x / 1.002, offset.z / 2.004), 1 + 1e-12) << u << ' ' << v;
    }
  }
  const Vec3 corner = area_offset(area, edges, 0, 0);
  EXPECT_NEAR(std::hypot(corner.x, corner.z / 2), .998, 1e-12) << "corners lie on the rim";
}

TEST(AreaGrid, that_is_oriented_faces_the_lit_point) {
  const AreaLight area{.edge_a = {3, 0, 0}, .edge_b = {0, 1, 0}, .count_a = 4, .count_b = 4, .orient = true};
  for (const Vec3& way : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 2, 3), Vec3(-.001, .002, 1)}) {
    const Vec3 to_light = way.normalized();
    const AreaEdges edges = edges_of(area, to_light);
    EXPECT_NEAR(edges.a.length(), 3, 1e-12);
    EXPECT_NEAR(edges.b.length(), 3, 1e-12);
    EXPECT_NEAR(edges.a.dot(to_light), 0, 1e-12);
    EXPECT_NEAR(edges.b.dot(to_light), 0, 1e-12);
    EXPECT_NEAR(edges.a.dot(edges.b), 0, 1e-12);
  }
}

}  // namespace
}  // namespace isl::render::test
