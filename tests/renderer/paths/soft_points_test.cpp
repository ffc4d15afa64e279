#include "renderer/paths/soft_points.h"

#include "renderer/paths/place_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace isl::render::test {
namespace {

/// The points of the first samples of a pixel.
std::vector<UnitPoint> centred(const SampledSquare& square, std::uint32_t seed, std::uint32_t first,
                               std::uint32_t count) {
  std::vector<PixelSample> samples;
  for (std::uint32_t i = 0; i < count; ++i) samples.push_back({seed, first + i, 4096});
  std::vector<UnitPoint> points(count);
  set_centred_points(square, samples, points);
  return points;
}

constexpr SampledSquare kSquares[] = {kLensSquare, pixel_square(true), pixel_square(false)};

TEST(CentredPoints, begin_in_the_middle_and_hit_every_rectangle_once) {
  for (const SampledSquare& square : kSquares) {
    for (const std::uint32_t seed : {3U, 4U, 99U, 0xdeadbeefU}) {
      for (const int m : {2, 4, 5, 8}) {
        const std::vector<UnitPoint> points = centred(square, seed, 0, 1U << m);
        EXPECT_EQ(points[0].u, 0);
        EXPECT_EQ(points[0].v, 0);
        for (int columns = 0; columns <= m; ++columns) {
          std::set<std::uint32_t> cells;
          for (std::size_t i = 1; i < points.size(); ++i) {
            const UnitPoint& point = points[i];
            ASSERT_TRUE(point.u >= -0.5 && point.u < 0.5 && point.v >= -0.5 && point.v < 0.5);
            const auto column = static_cast<std::uint32_t>(std::ldexp(point.u + 0.5, columns));
            const auto row = static_cast<std::uint32_t>(std::ldexp(point.v + 0.5, m - columns));
            cells.insert(row << 16 | column);
          }
          // The first point is on the edge of its rectangle.
          EXPECT_EQ(cells.size(), points.size() - 1) << seed << " " << m << " " << columns;
        }
      }
    }
  }
}

TEST(CentredPoints, are_the_same_whatever_run_they_come_in) {
  for (const SampledSquare& square : kSquares) {
    const std::vector<UnitPoint> all = centred(square, 7, 0, 300);
    for (const std::uint32_t first : {0U, 5U, 201U}) {
      for (const std::uint32_t count : {1U, 4U, 77U}) {
        const std::vector<UnitPoint> points = centred(square, 7, first, count);
        for (std::uint32_t i = 0; i < count; ++i) {
          EXPECT_EQ(points[i].u, all[first + i].u) << first << " " << i;
          EXPECT_EQ(points[i].v, all[first + i].v) << first << " " << i;
        }
      }
    }
  }
}

TEST(CentredPoints, lie_in_the_mean_in_the_middle) {
  // One of four points is the middle. Each of the others has a variance of at most 1/12, and pixels are independent.
  constexpr std::uint32_t kPixels = 4000;
  for (const SampledSquare& square : kSquares) {
    double u = 0, v = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
      for (const UnitPoint& point : centred(square, pixel_seed(static_cast<int>(pixel), 3), 0, 4)) {
        u += point.u / 4;
        v += point.v / 4;
      }
    }
    const double bound = 5 * std::sqrt(3.0 / 16 / 12 * kPixels);
    EXPECT_LT(std::abs(u), bound);
    EXPECT_LT(std::abs(v), bound);
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
