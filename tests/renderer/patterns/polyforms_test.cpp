// Polyforms: facts that follow from their definition. The values of the pattern are compared with POV-Ray's in
// tests/povray/probes/.
#include "renderer/patterns/kinds/polyforms.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

namespace isl::render {
namespace {

/// A polygon of the lattice; of a rhomb of two triangles the upright one is 0, the hanging one 1.
using Polygon = std::tuple<int, int, int>;

/// The polygons beside one that no border parts from it.
std::vector<Polygon> joined_to(const Polygon& polygon, int sides, const PolyformBorders& is_border) {
  const auto [i, j, half] = polygon;
  std::vector<Polygon> joined;
  const auto look = [&](int column, int row, int bit, const Polygon& other) {
    if (!is_border(column, row, bit)) joined.push_back(other);
  };
  if (sides == 4) {
    look(i, j, 0, {i + 1, j, 0});
    look(i, j, 1, {i, j + 1, 0});
    look(i - 1, j, 0, {i - 1, j, 0});
    look(i, j - 1, 1, {i, j - 1, 0});
  } else if (sides == 6) {
    look(i, j, 0, {i + 1, j, 0});
    look(i, j, 1, {i, j + 1, 0});
    look(i, j, 2, {i - 1, j + 1, 0});
    look(i - 1, j, 0, {i - 1, j, 0});
    look(i, j - 1, 1, {i, j - 1, 0});
    look(i + 1, j - 1, 2, {i + 1, j - 1, 0});
  } else if (half == 0) {
    look(i, j, 0, {i, j - 1, 1});
    look(i, j, 1, {i, j, 1});
    look(i, j, 2, {i - 1, j, 1});
  } else {
    look(i, j + 1, 0, {i, j + 1, 0});
    look(i, j, 1, {i, j, 0});
    look(i + 1, j, 2, {i + 1, j, 0});
  }
  return joined;
}

/// All that hangs together with a polygon, as far as `most`.
std::set<Polygon> polyform_around(const Polygon& start, int sides, const PolyformBorders& is_border, std::size_t most) {
  std::set<Polygon> found{start};
  std::vector<Polygon> open{start};
  while (!open.empty() && found.size() <= most) {
    const Polygon polygon = open.back();
    open.pop_back();
    for (const Polygon& other : joined_to(polygon, sides, is_border)) {
      if (found.insert(other).second) open.push_back(other);
    }
  }
  return found;
}

TEST(Polyforms, HaveAsManyPolygonsAsTheyShould) {
  int count = 0;
  for (const int sides : {3, 4, 6}) {
    for (int tiles = 1; tiles <= 6; ++tiles) {
      for (int number = 1; number <= polyform_count(sides, tiles); ++number, ++count) {
        const PolyformBorders borders(sides, tiles, number);
        for (int i = -7; i < 7; ++i) {
          for (int j = -7; j < 7; ++j) {
            for (int half = 0; half < (sides == 3 ? 2 : 1); ++half) {
              const auto size = polyform_around({i, j, half}, sides, borders, 10).size();
              ASSERT_EQ(size, static_cast<std::size_t>(tiles)) << sides << " sides, number " << number;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(count, 112);
}

TEST(Polyforms, OfOneSizeDiffer) {
  // By the sizes of what their polygons touch: no two arrangements of one size have the same borders.
  for (const int sides : {3, 4, 6}) {
    for (int tiles = 1; tiles <= 6; ++tiles) {
      std::set<std::vector<bool>> seen;
      for (int number = 1; number <= polyform_count(sides, tiles); ++number) {
        const PolyformBorders is_border(sides, tiles, number);
        std::vector<bool> borders;
        for (int i = 0; i < 12; ++i) {
          for (int j = 0; j < 12; ++j) {
            for (int bit = 0; bit < (sides == 4 ? 2 : 3); ++bit) borders.push_back(is_border(i, j, bit));
          }
        }
        EXPECT_TRUE(seen.insert(borders).second) << sides << " sides, " << tiles << " tiles, number " << number;
      }
    }
  }
}

}  // namespace
}  // namespace isl::render
