#include "renderer/numerics/sample_points.h"

#include "renderer/numerics/density_table.h"
#include "renderer/numerics/directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace isl::render::test {
namespace {

TEST(SamplePoints, of_any_block_of_2_to_the_m_hit_every_rectangle_once) {
  const auto check = [](const PointSequence& sequence) {
    for (const int m : {1, 3, 4, 6, 8, 10}) {
      const std::uint32_t count = 1U << m;
      for (const std::uint32_t first : {0U, count, 5 * count, 1000 * count}) {
        for (int columns = 0; columns <= m; ++columns) {
          std::set<std::uint32_t> cells;
          for (std::uint32_t i = 0; i < count; ++i) {
            const UnitPoint point = sequence[first + i];
            ASSERT_TRUE(point.u >= 0 && point.u < 1 && point.v >= 0 && point.v < 1);
            const auto column = static_cast<std::uint32_t>(std::ldexp(point.u, columns));
            const auto row = static_cast<std::uint32_t>(std::ldexp(point.v, m - columns));
            cells.insert(row << 16 | column);
          }
          EXPECT_EQ(cells.size(), count) << sequence.seed << " " << m << " " << first << " " << columns;
        }
      }
    }
  };
  for (const std::uint32_t seed : {0U, 1U, 12345U, 0xdeadbeefU}) {
    check({seed, seed});
    check({seed, seed, SobolPair::second});
  }
}

TEST(SamplePoints, of_different_seeds_have_nothing_to_do_with_one_another) {
  // The correlation of n random pairs is below 5/√n with a probability of 1 - 6e-7.
  constexpr std::uint32_t kSeeds = 20000;
  for (const std::uint32_t number : {0U, 1U, 7U}) {
    double sum = 0, crossed = 0, next = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      const UnitPoint a = sample_point(derived_seed(seed, 3), number), b = sample_point(derived_seed(seed, 4), number);
      const UnitPoint c = sample_point(derived_seed(seed + 1, 3), number);
      sum += (a.u - 0.5) * (b.u - 0.5) * 12;
      crossed += (a.u - 0.5) * (a.v - 0.5) * 12;
      next += (a.u - 0.5) * (c.u - 0.5) * 12;
    }
    const double bound = 5 * std::sqrt(static_cast<double>(kSeeds));
    EXPECT_LT(std::abs(sum), bound);
    EXPECT_LT(std::abs(crossed), bound);
    EXPECT_LT(std::abs(next), bound);
  }
}

TEST(SamplePoints, edges_converge_as_they_should) {
  // The share of the square below a slanted edge: the variance of a scrambled net of n points falls as n^-3/2, that of
  // random ones as n^-1.
  const auto deviation = [](std::uint32_t count) {
    constexpr std::uint32_t kSeeds = 400;
    double squares = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      const double slope = 0.2 + 0.6 * sample_point(77, seed).u, start = 0.2 * sample_point(77, seed).v;
      std::uint32_t below = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        const UnitPoint point = sample_point(seed, i);
        below += point.v < start + slope * point.u ? 1 : 0;
      }
      const double error = static_cast<double>(below) / count - (start + slope / 2);
      squares += error * error;
    }
    return std::sqrt(squares / kSeeds);
  };
  for (const std::uint32_t count : {64U, 256U, 4096U}) EXPECT_LT(deviation(count), 0.45 * std::pow(count, -0.75));
}

TEST(SamplePoints, of_both_pairs_hit_every_box_of_four_dimensions) {
  // 2^m points, of which 2^t lie in every box of the volume 2^(t-m) that comes from halving the sides.
  for (const auto& [m, t] : {std::pair(2, 1), {4, 1}, {6, 2}, {8, 3}, {9, 2}}) {
    for (const std::uint32_t order : {0U, 7U, 0xdeadbeefU}) {
      const PointSequence one{order, derived_seed(order, 1)}, other{order, derived_seed(order, 2), SobolPair::second};
      for (const std::uint32_t first : {0U, 5U << m}) {
        for (int a = 0; a <= m - t; ++a) {
          for (int b = 0; a + b <= m - t; ++b) {
            for (int c = 0; a + b + c <= m - t; ++c) {
              const int d = m - t - a - b - c;
              std::vector<int> boxes(1U << (m - t));
              for (std::uint32_t i = 0; i < 1U << m; ++i) {
                const UnitPoint p = one[first + i], q = other[first + i];
                std::size_t box = 0;
                for (const auto& [value, halvings] : {std::pair(p.u, a), {p.v, b}, {q.u, c}, {q.v, d}})
                  box = box << halvings | static_cast<std::size_t>(std::ldexp(value, halvings));
                ++boxes[box];
              }
              for (const int count : boxes) ASSERT_EQ(count, 1 << t) << m << " " << order << " " << a << b << c << d;
            }
          }
        }
      }
    }
  }
}

TEST(SamplePoints, of_both_pairs_find_an_edge_across_both_squares_better_than_points_of_their_own) {
  // The share of what a square lens as large as a pixel sees of one side of an edge.
  constexpr std::uint32_t kEdges = 1000, kPoints = 256, kExact = 1U << 14;
  double squares[2] = {};
  for (std::uint32_t edge = 0; edge < kEdges; ++edge) {
    const UnitPoint random = sample_point(77, edge);
    const double x = std::cos(2 * std::numbers::pi * random.u), y = std::sin(2 * std::numbers::pi * random.u);
    const PointSequence one{edge, derived_seed(edge, 1)};
    const auto share_below = [&](const PointSequence& other, std::uint32_t count) {
      std::uint32_t below = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        const UnitPoint p = one[i], q = other[i];
        below += x * (p.u + q.u - 1) + y * (p.v + q.v - 1) < random.v - 0.5 ? 1 : 0;
      }
      return static_cast<double>(below) / count;
    };
    const PointSequence together{edge, derived_seed(edge, 2), SobolPair::second};
    const PointSequence apart{derived_seed(edge, 2), derived_seed(edge, 2)};
    const double exact = share_below(together, kExact);
    squares[0] += std::pow(share_below(together, kPoints) - exact, 2);
    squares[1] += std::pow(share_below(apart, kPoints) - exact, 2);
  }
  EXPECT_LT(squares[0], 0.7 * squares[1]);
}

TEST(DensityTable, chooses_by_its_weights) {
  const DensityTable table(3, 2, {1, 0, 2, 0, 3, 0});
  std::vector<double> shares(6);
  constexpr std::uint32_t kPoints = 1U << 14;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const DensityTable::Place place = table.place(sample_point(5, i));
    const auto cell = static_cast<std::size_t>(place.u * 3) + 3 * static_cast<std::size_t>(place.v * 2);
    shares.at(cell) += 1.0 / kPoints;
    EXPECT_EQ(place.density, table.density(place.u, place.v));
  }
  const std::vector<double> expected{1 / 6.0, 0, 2 / 6.0, 0, 3 / 6.0, 0};
  // Each cell is a rectangle of the square of points, which a net misjudges by at most four points for its four sides.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(shares[i], expected[i], 4.0 * 14 / kPoints) << i;
  EXPECT_DOUBLE_EQ(table.density(0.1, 0.1), 1);
  EXPECT_DOUBLE_EQ(table.density(0.5, 0.9), 3);
}

TEST(DensityTable, without_weights_is_even) {
  const DensityTable table(4, 4, std::vector<double>(16));
  const DensityTable::Place place = table.place({0.3, 0.7});
  EXPECT_NEAR(place.u, 0.3, 1e-15);
  EXPECT_NEAR(place.v, 0.7, 1e-15);
  EXPECT_EQ(place.density, 1);
}

TEST(Directions, by_cosines_have_their_moments) {
  // Over the hemisphere with density cos θ/π, the mean of cos θ is 2/3 and that of the direction across is 0.
  for (const Imath::V3d& normal :
       {Imath::V3d(0, 0, 1), Imath::V3d(0, 0, -1), Imath::V3d(1, 2, -3).normalized(), Imath::V3d(1, 0, 0)}) {
    Imath::V3d mean(0);
    constexpr std::uint32_t kPoints = 1U << 12;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const Imath::V3d direction = cosine_direction(sample_point(8, i), normal);
      EXPECT_NEAR(direction.length(), 1, 1e-14);
      EXPECT_GE(direction.dot(normal), 0);
      mean += direction / kPoints;
    }
    EXPECT_NEAR((mean - normal * (2.0 / 3)).length(), 0, 1e-3);
  }
}

TEST(Directions, of_the_sphere_come_back_to_their_points) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const UnitPoint point = sample_point(9, i), back = sphere_point(sphere_direction(point));
    // Half a dozen roundings of numbers up to 2π, enlarged near the poles, where the turn is that of a short vector.
    EXPECT_NEAR(point.v, back.v, 1e-15);
    EXPECT_NEAR(point.u, back.u, 1e-13);
  }
}

}  // namespace
}  // namespace isl::render::test
