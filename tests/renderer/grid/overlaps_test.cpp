// Blobs that are hard for a grid: large balls overlap everywhere, and among them are plates, threads, half-spaces and
// small balls. Their grids stay small, whatever limit they are given they find the same surface, and they do not depend
// on the number of threads.
#include "base/parallel.h"
#include "renderer/fields/component_table.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/trace/tracer.h"
#include "tests/renderer/grid/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace isl::render {
namespace {

/// A component of any skeleton within about one unit of the origin.
scene::Component component(Random& random, scene::Skeleton skeleton, double radius, scene::Blob& blob) {
  scene::Component c;
  c.skeleton = skeleton;
  c.a = random.in_cube();
  c.b = has(skeleton, scene::kDirectionB) ? random.in_cube().normalized() : random.in_cube();
  if (skeleton == scene::Skeleton::box) {
    for (int axis = 0; axis < 3; ++axis) c.b[axis] = c.a[axis] + random.unit();
  }
  c.radius_a = radius;
  c.radius_b = has(skeleton, scene::kDirectionB) ? random.between(0.3, 1) : radius;
  if (has(skeleton, scene::kCorner)) {
    c.corner = static_cast<std::uint32_t>(blob.corners.size());
    blob.corners.push_back(random.in_cube());
  }
  return c;
}

void add(scene::Blob& blob, const scene::Component& component) {
  blob.components.push_back(component);
  blob.origins.push_back({});
}

void add_large_balls(scene::Blob& blob, Random& random, int count) {
  for (int i = 0; i < count; ++i) {
    scene::Component ball;
    ball.a = random.in_cube();
    ball.radius_a = random.between(0.5, 1.5);
    ball.strength = i % 3 == 2 ? -0.6 : 0.5;
    add(blob, ball);
  }
}

scene::Database one_blob() {
  scene::Database database;
  database.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4});
  database.blobs.emplace_back();
  database.objects.push_back({.kind = scene::Object::Kind::blob, .shape = 0});
  return database;
}

Grid grid_of(const ComponentTable& table, CellRule rule = CellRule::ranges) {
  GridBudget budget;
  return build_blob_grid(table, rule, budget);
}

constexpr scene::Skeleton kThin[] = {scene::Skeleton::plane, scene::Skeleton::triangle, scene::Skeleton::segment,
                                     scene::Skeleton::disc, scene::Skeleton::box};

TEST(Overlaps, OneThinThingAmongLargeBallsDoesNotFillMemory) {
  for (const scene::Skeleton skeleton : kThin) {
    for (const double radius : {1e-2, 3e-3, 1e-4, 1e-6}) {
      SCOPED_TRACE(std::to_string(static_cast<int>(skeleton)) + " " + std::to_string(radius));
      Random random(7);
      scene::Database database = one_blob();
      add_large_balls(database.blobs[0], random, 16);
      add(database.blobs[0], component(random, skeleton, radius, database.blobs[0]));
      const ComponentTable table = compile_components(database, database.blobs[0]);
      EXPECT_LT(grid_of(table).bytes(), 10'000'000U);
      EXPECT_LT(grid_of(table, CellRule::none).bytes(), 10'000'000U);
      EXPECT_LT(grid_of(table, CellRule::lipschitz).bytes(), 100'000'000U);  // its authors divide by size alone
    }
  }
}

scene::Database random_overlaps(std::uint64_t seed) {
  Random random(seed);
  scene::Database database = one_blob();
  add_large_balls(database.blobs[0], random, 4 + static_cast<int>(random.between(0, 16)));
  for (int i = 0; i < 30; ++i) {
    const auto skeleton = static_cast<scene::Skeleton>(i % (static_cast<int>(scene::Skeleton::plane) + 1));
    scene::Component c = component(random, skeleton, std::pow(10, random.between(-4, -1)), database.blobs[0]);
    c.strength = skeleton == scene::Skeleton::plane ? random.between(-0.4, 0.2) : random.between(-1, 2);
    add(database.blobs[0], c);
  }
  return database;
}

std::vector<Hit> hits(const scene::Database& database, std::size_t most_grid_bytes, const std::vector<Ray>& rays) {
  TracerOptions options;
  options.most_grid_bytes = most_grid_bytes;
  options.tolerance = {1e-9, false};
  const Tracer tracer(database, options);
  std::vector<Hit> hits(rays.size());
  TraceCounters counters;
  tracer.first_hits(rays, hits, counters);
  return hits;
}

TEST(Overlaps, TheSameSurfaceIsFoundWhateverAGridMayCost) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scene::Database database = random_overlaps(seed);
    Random random(100 + seed);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
      const Vec3 origin = random.in_cube() * 6;
      rays.push_back({origin, (random.in_cube() - origin).normalized(), 1e3, 0, {}});
    }
    const std::vector<Hit> expected = hits(database, 0, rays);
    for (const std::size_t bytes : {std::size_t{20'000}, std::size_t{300'000}, ~std::size_t{0}}) {
      const std::vector<Hit> actual = hits(database, bytes, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        SCOPED_TRACE("blob " + std::to_string(seed) + ", " + std::to_string(bytes) + " bytes, ray " +
                     std::to_string(i));
        ASSERT_EQ(actual[i].is_miss(), expected[i].is_miss());
        if (actual[i].is_miss()) continue;
        ASSERT_NEAR(actual[i].t, expected[i].t, 2e-9);
        ++found;
      }
    }
  }
  EXPECT_GT(found, 10'000);
}

TEST(Overlaps, AGridKeepsItsLimit) {
  const scene::Database database = random_overlaps(3);
  const ComponentTable table = compile_components(database, database.blobs[0]);
  const std::size_t top = [&] {
    GridBudget none(0);
    return build_blob_grid(table, CellRule::ranges, none).bytes();
  }();
  std::size_t before = top;
  for (const std::size_t limit : {std::size_t{50'000}, std::size_t{500'000}, std::size_t{5'000'000}}) {
    GridBudget budget(limit);
    const std::size_t bytes = build_blob_grid(table, CellRule::ranges, budget).bytes();
    EXPECT_LE(bytes, std::max(limit, top) + 1000);
    EXPECT_GT(bytes, before);
    before = bytes;
  }
}

TEST(Overlaps, GridsAreTheSameWhateverTheNumberOfThreads) {
  const scene::Database database = random_overlaps(5);
  const ComponentTable table = compile_components(database, database.blobs[0]);
  Grid one, many;
  with_threads(1, [&] { one = grid_of(table); });
  with_threads(4, [&] { many = grid_of(table); });
  EXPECT_EQ(one.items, many.items);
  EXPECT_EQ(one.cells, many.cells);
}

TEST(Overlaps, ABallAsLargeAsNumbersGoTakesNoMemory) {
  for (const double radius : {1e100, 1e154, 1e155, 1e300, 1e308}) {
    scene::Database database = one_blob();
    scene::Blob& blob = database.blobs[0];
    Random random(1);
    for (int i = 0; i < 30; ++i) {
      add(blob,
          component(random, static_cast<scene::Skeleton>(i % static_cast<int>(scene::Skeleton::plane)), 0.3, blob));
    }
    scene::Component ball;
    ball.radius_a = radius;
    add(blob, ball);
    const ComponentTable table = compile_components(database, blob);
    EXPECT_LT(grid_of(table).bytes(), 4U << 20) << radius;
  }
}

}  // namespace
}  // namespace isl::render
