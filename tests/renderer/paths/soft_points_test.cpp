#include "renderer/paths/soft_points.h"

#include "renderer/paths/place_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::render::test {
namespace {

TEST(CentredPoints, begin_in_the_middle_and_stay_even) {
  for (const std::uint32_t seed : {3U, 4U, 99U}) {
    std::vector<UnitPoint> points(256);
    CentredPoints({seed, seed}).fill(0, points);
    EXPECT_EQ(points[0].u, 0);
    EXPECT_EQ(points[0].v, 0);
    std::vector<int> cells(16);
    for (const UnitPoint& point : points) {
      ASSERT_TRUE(point.u >= -0.5 && point.u < 0.5 && point.v >= -0.5 && point.v < 0.5);
      ++cells[static_cast<std::size_t>(point.u * 16 + 8)];
    }
    // A moved interval of a sixteenth holds the points of two parts of such.
    for (const int count : cells) EXPECT_NEAR(count, 16, 1);
  }
}

TEST(CentredPoints, are_those_of_the_sequence_whatever_run_they_come_in) {
  const auto wrapped = [](double v) { return v - std::floor(v + 0.5); };
  for (const SobolPair pair : {SobolPair::first, SobolPair::second}) {
    const PointSequence sequence{7, 8, pair};
    const UnitPoint middle = sequence[0];
    for (const std::uint32_t first : {0U, 5U, 4000U}) {
      for (const std::size_t count : {1U, 4U, 77U}) {
        std::vector<UnitPoint> points(count);
        CentredPoints(sequence).fill(first, points);
        for (std::uint32_t i = 0; i < count; ++i) {
          const UnitPoint point = sequence[first + i];
          EXPECT_EQ(points[i].u, wrapped(point.u - middle.u)) << first << " " << i;
          EXPECT_EQ(points[i].v, wrapped(point.v - middle.v)) << first << " " << i;
        }
      }
    }
  }
}

TEST(SoftPoints, are_the_same_one_by_one_and_many_at_a_time) {
  std::vector<SoftPlace> places;
  for (std::uint32_t i = 0; i < 43; ++i) {
    places.push_back({i * i, i % 5, 1000 - 7 * i});
    std::vector<UnitPoint> points(places.size());
    set_points(places, points);
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_EQ(points[k].u, places[k].point().u) << i << " " << k;
      EXPECT_EQ(points[k].v, places[k].point().v) << i << " " << k;
    }
  }
}

TEST(PlaceOrder, has_every_point_once_and_neighbours_together) {
  constexpr std::uint32_t kPoints = 256;
  std::vector<UnitPoint> points;
  for (std::uint32_t i = 0; i < kPoints; ++i) points.push_back(sample_point(5, i));
  PlaceOrder place_order;
  const std::span<const std::uint32_t> order = place_order.of(points);
  std::vector<std::uint32_t> numbers(order.begin(), order.end());
  // Sixteen points lie in each of the sixteen parts.
  for (std::size_t first = 0; first < kPoints; first += 16) {
    for (std::size_t i = first; i < first + 16; ++i) {
      EXPECT_LT(std::abs(points[order[i]].u - points[order[first]].u), 0.25);
      EXPECT_LT(std::abs(points[order[i]].v - points[order[first]].v), 0.25);
    }
  }
  std::ranges::sort(numbers);
  for (std::uint32_t i = 0; i < kPoints; ++i) ASSERT_EQ(numbers[i], i);
  EXPECT_EQ(place_order.of(std::span(points).first(1)).front(), 0);
  EXPECT_TRUE(place_order.of({}).empty());
}

}  // namespace
}  // namespace isl::render::test
