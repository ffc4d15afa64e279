// The cores of cells: outside them no field reaches the threshold, whatever fields a blob has and however they are
// combined, and they are small enough to be worth something.
#include "renderer/fields/component_table.h"
#include "renderer/grid/blob_grid.h"
#include "tests/renderer/grid/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace isl::render {
namespace {

enum class Combination { sum, carved, greatest, branches };

scene::Database random_blob(std::uint64_t seed, const scene::Kernel& kernel, Combination combination) {
  Random random(seed);
  scene::Database database;
  database.kernels = {kernel, {scene::KernelShape::quartic, scene::RadiusMeaning::surface, 2}};
  scene::Blob& blob = database.blobs.emplace_back();
  blob.threshold = random.between(0.3, 1);
  blob.is_unblended = combination == Combination::greatest;
  if (combination == Combination::branches) {
    for (const scene::Branch& branch : {scene::Branch{0, 0}, {0, 1}, {0, 1}, {0, 1}}) blob.branches.push_back(branch);
  }
  for (std::uint32_t i = 0; i < 60; ++i) {
    const bool carves = combination == Combination::carved && i % 3 == 0;
    blob.components.push_back({.a = random.in_cube(),
                               .radius_a = random.between(0.05, 0.3),
                               .strength = (carves ? -1 : 1) * random.between(0.5, 1.5),
                               .kernel = static_cast<scene::KernelId>(i % 4 == 3)});
    blob.origins.push_back({});
    if (combination == Combination::branches) blob.branch_of.push_back(i % 4);
  }
  return database;
}

/// The field at a point, from the ranges over a box of no size.
double field_value(const ComponentTable& table, const Vec3& p) {
  std::vector<double> sums(std::max(table.tree.size(), 1U));
  double greatest = 0;
  for (const FieldGroup& group : table.groups) {
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      const double value = field_range(table, group, i, Box(p, p)).high;
      sums[table.branch.empty() ? 0 : table.branch[i]] += value;
      greatest = std::max(greatest, value);
    }
  }
  if (table.tree.size() > 0) table.tree.add_up(sums);
  return table.is_unblended ? greatest : sums[0];
}

/// Calls use(cell, corner, size) for each cell that is not empty.
template <class Use>
void for_each_cell(const Grid& grid, std::uint32_t first, const Vec3& low, double size, const Use& use) {
  for (std::uint32_t i = first; i < first + kBrickCells; ++i) {
    const Cell& cell = grid.cells[i];
    if (cell.kind() == CellKind::empty) continue;
    const Vec3 corner = low + Vec3(double(i & 3), double(i >> 2 & 3), double(i >> 4 & 3)) * size;
    use(cell, corner, size);
    if (cell.kind() == CellKind::brick) for_each_cell(grid, cell.first, corner, size / kBrickSide, use);
  }
}

Box core_of(const Cell& cell, const Vec3& corner, double size) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    box.min[axis] = corner[axis] + cell.core.from_low[i] * size / CellCore::kParts;
    box.max[axis] = corner[axis] + size - cell.core.from_high[i] * size / CellCore::kParts;
  }
  return box;
}

class Cores : public testing::TestWithParam<Combination> {};

TEST_P(Cores, HoldAllThatReachesTheThreshold) {
  const scene::Kernel kernels[] = {{scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4},
                                   {scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4},
                                   {scene::KernelShape::cauchy, scene::RadiusMeaning::surface, 30},
                                   {scene::KernelShape::metaball, scene::RadiusMeaning::surface, 1}};
  double leaves = 0, kept = 0;
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const scene::Database database = random_blob(seed, kernels[seed % std::size(kernels)], GetParam());
    const ComponentTable table = compile_components(database, database.blobs[0]);
    GridBudget budget;
    const Grid grid = build_blob_grid(table, CellRule::ranges, budget);
    Random random(100 + seed);
    for_each_cell(grid, 0, grid.box.min, grid.cell_size, [&](const Cell& cell, const Vec3& corner, double size) {
      const Box core = core_of(cell, corner, size);
      for (int i = 0; i < 12; ++i) {
        const Vec3 p = corner + Vec3(random.unit(), random.unit(), random.unit()) * size;
        if (core.intersects(p)) continue;
        ++outside;
        ASSERT_LT(field_value(table, p), table.threshold);
      }
      if (cell.kind() == CellKind::brick || cell.kind() == CellKind::inside) return;
      ++leaves;
      const Vec3 sides = core.size() / size;
      kept += sides.x * sides.y * sides.z;
    });
  }
  EXPECT_GT(outside, 5000);
  EXPECT_LT(kept / leaves, 0.9);
}

std::string name_of(const testing::TestParamInfo<Combination>& given) {
  constexpr std::string_view kNames[] = {"sum", "carved", "greatest", "branches"};
  return std::string(kNames[static_cast<std::size_t>(given.param)]);
}

INSTANTIATE_TEST_SUITE_P(Combinations, Cores,
                         testing::Values(Combination::sum, Combination::carved, Combination::greatest,
                                         Combination::branches),
                         name_of);

TEST(CellCores, AreCalledForWhereTheyAreMuchSmallerThanTheirCells) {
  using Sides = std::array<std::uint8_t, 3>;
  EXPECT_FALSE(CellCore().is_worth_a_look());
  const Vec3 low(3, -2, 7);
  const CellCore most = CellCore::around(Box(low + Vec3(0.1, 0, 0), low + Vec3(2, 2, 2)), low, 2, 0);
  EXPECT_EQ(most.from_low, (Sides{12, 0, 0}));
  EXPECT_EQ(most.from_high, (Sides{0, 0, 0}));
  EXPECT_FALSE(most.is_worth_a_look());
  const CellCore corner = CellCore::around(Box(low + Vec3(1.5), low + Vec3(1.75)), low, 2, 0.25);
  EXPECT_EQ(corner.from_low, (Sides{160, 160, 160}));
  EXPECT_EQ(corner.from_high, (Sides{0, 0, 0}));
  EXPECT_TRUE(corner.is_worth_a_look());
  // A core without extent at the far side still is one.
  const CellCore border = CellCore::around(Box(low + Vec3(2), low + Vec3(2)), low, 2, 0);
  EXPECT_EQ(border.from_low, (Sides{255, 255, 255}));
  EXPECT_EQ(border.from_high, (Sides{0, 0, 0}));
}

}  // namespace
}  // namespace isl::render
