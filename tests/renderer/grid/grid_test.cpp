// The properties of the grid: its stretches of a ray join without gaps, a cell's list holds everything that matters,
// and cells are classified correctly.
#include "renderer/fields/component_table.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/grid/grid_walk-inl.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace isl::render {
namespace {

class Rays {
 public:
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  Vec3 in_cube() { return Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1); }

 private:
  std::mt19937_64 bits_{11};
};

struct Flake {
  ComponentTable components;
  Grid grid;

  explicit Flake(int levels, CellRule rule = CellRule::ranges) {
    const scene::Database database =
        test::sphereflake(levels, {scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
    components = compile_components(database, database.blobs[0]);
    GridBudget budget;
    grid = build_blob_grid(components, rule, budget);
  }
};

struct Stretch {
  std::uint32_t cell;
  double t0, t1;
};

std::vector<Stretch> stretches(const Grid& grid, const Vec3& origin, const Vec3& direction) {
  std::vector<Stretch> result;
  const HWY_NAMESPACE::BoxSpan span = HWY_NAMESPACE::clip_to_box(grid.box, origin, direction, 0, 1e9);
  if (!(span.enter < span.leave)) return result;
  HWY_NAMESPACE::walk(grid, origin, direction, span.enter, span.leave,
                      [&](std::uint32_t index, const Cell&, double t0, double t1) {
                        result.push_back({index, t0, t1});
                        return false;
                      });
  return result;
}

/// The sum of all fields at a point, from the ranges over a box of no size.
double value_at(const ComponentTable& table, const Vec3& p) {
  double sum = 0;
  for (const FieldGroup& group : table.groups) {
    for (std::uint32_t i = group.begin; i < group.end; ++i) sum += field_range(table, group, i, Box(p, p)).low;
  }
  return sum;
}

TEST(Grid, StretchesAscendAndDoNotOverlap) {
  const Flake flake(2);
  Rays rays;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 origin = rays.in_cube() * 3, direction = rays.in_cube() - origin;
    double reached = 0;
    for (const Stretch& s : stretches(flake.grid, origin, direction)) {
      ASSERT_LT(s.t0, s.t1);
      ASSERT_GE(s.t0, reached);
      reached = s.t1;
    }
  }
}

void expect_nothing_between_the_stretches(const Flake& flake) {
  // At any point of a ray, the field is above the threshold only within a stretch, and there the cell's own list gives
  // the whole field.
  Rays rays;
  int inside = 0;
  for (int i = 0; i < 120; ++i) {
    const Vec3 origin = rays.in_cube() * 3, direction = rays.in_cube() * 0.8 - origin;
    const std::vector<Stretch> all = stretches(flake.grid, origin, direction);
    for (int k = 0; k < 60; ++k) {
      const double t = 0.4 + 1.2 * rays.unit();
      const Vec3 p = origin + direction * t;
      const double value = value_at(flake.components, p);
      const auto at = std::find_if(all.begin(), all.end(), [&](const Stretch& s) { return s.t0 <= t && t <= s.t1; });
      if (at == all.end()) {
        ASSERT_LT(value, flake.components.threshold);
        continue;
      }
      const Cell cell = flake.grid.cells[at->cell];
      if (cell.kind() == CellKind::inside) {
        ASSERT_GT(value, flake.components.threshold);
        ++inside;
        continue;
      }
      double listed = 0;
      for (std::uint32_t n = 0; n < cell.count(); ++n) {
        const std::uint32_t item = flake.grid.items[cell.first + n];
        listed += field_range(flake.components, flake.components.group_of(item), item, Box(p, p)).low;
      }
      ASSERT_NEAR(listed, value, 1e-12 * (1 + value));
    }
  }
  EXPECT_GT(inside, 10);
}

TEST(Grid, NothingLiesBetweenTheStretches) { expect_nothing_between_the_stretches(Flake(3)); }

TEST(Grid, NothingLiesBetweenThoseOfAnOctreeCulledByLipschitzConstants) {
  expect_nothing_between_the_stretches(Flake(3, CellRule::lipschitz));
}

TEST(Grid, AxisParallelRaysAndRaysInPlanesOfCellsMeetTheSameCells) {
  const Flake flake(1);
  const Grid& grid = flake.grid;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (const double zero : {0.0, -0.0}) {
        for (int plane = 0; plane <= 8; ++plane) {  // lines on planes of the top brick's cells and between them
          Vec3 origin = grid.box.min + Vec3(grid.cell_size * plane / 2), direction(zero);
          origin[axis] = -5 * sign;
          direction[axis] = sign;
          double covered = 0;
          for (const Stretch& s : stretches(grid, origin, direction)) {
            covered += s.t1 - s.t0;
            const Vec3 p = origin + direction * (0.5 * (s.t0 + s.t1));
            ASSERT_TRUE(grid.box.intersects(p));
          }
          // Stretches cover every place on the line where the field is above the threshold.
          for (double t = 3.5; t < 6.5; t += 0.01) {
            if (value_at(flake.components, origin + direction * t) > flake.components.threshold) {
              ASSERT_GT(covered, 0);
            }
          }
        }
      }
    }
  }
}

TEST(Grid, EmptyBlobHasAnEmptyGrid) {
  GridBudget budget;
  const Grid grid = build_blob_grid(ComponentTable{}, CellRule::ranges, budget);
  EXPECT_TRUE(grid.is_empty());
  EXPECT_TRUE(grid.bounds.isEmpty());
}

TEST(Grid, TwoClustersFarApartCostNoMoreThanTwo) {
  scene::Database database;
  database.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  scene::Blob blob;
  for (const double x : {0.0, 1e6}) {
    for (int i = 0; i < 40; ++i) {
      blob.components.push_back({.a = Vec3(x + 0.1 * i, std::sin(i), std::cos(i)), .radius_a = 0.3});
      blob.origins.push_back({});
    }
  }
  const ComponentTable table = compile_components(database, blob);
  GridBudget budget;
  EXPECT_LT(build_blob_grid(table, CellRule::ranges, budget).bytes(), 4U << 20);
}

TEST(Grid, AThreadAMillionTimesAsLongAsThickDoesNotFillMemory) {
  scene::Database database;
  database.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  scene::Blob blob;
  for (const Vec3& end : {Vec3(1, 0.3, 0.2), Vec3(-0.4, 1, 0.1)}) {
    blob.components.push_back({.a = Vec3(0, 0, 0), .b = end, .radius_a = 1e-6, .skeleton = scene::Skeleton::segment});
    blob.origins.push_back({});
  }
  const ComponentTable table = compile_components(database, blob);
  for (const CellRule rule : {CellRule::ranges, CellRule::lipschitz}) {
    GridBudget budget;
    EXPECT_LT(build_blob_grid(table, rule, budget).bytes(), 4U << 20);
  }
}

}  // namespace
}  // namespace isl::render
