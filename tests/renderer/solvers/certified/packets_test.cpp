// Rays in packets have the same hits as single rays, and meet the same cells.
#include "renderer/fields/packet/ray_packet.h"
#include "renderer/trace/tracer.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace isl::render {
namespace {

struct Traced {
  std::vector<Hit> hits;
  std::vector<std::uint8_t> occluded;
  TraceCounters counters;
};

Traced traced(const scene::Database& database, bool packets, const std::vector<Ray>& rays) {
  TracerOptions options;
  options.packets = packets;
  const Tracer tracer(database, options);
  Traced result{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size()), {}};
  tracer.first_hits(rays, result.hits, result.counters);
  tracer.occlusions(rays, result.occluded, result.counters);
  return result;
}

/// Returns the number of rays that hit. `odd_cells`: the share of cells that one walk may take and the other leave out.
int expect_same(const scene::Database& database, const std::vector<Ray>& rays, double odd_cells = 1e-3) {
  const Traced alone = traced(database, false, rays), together = traced(database, true, rays);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit &a = alone.hits[i], &b = together.hits[i];
    EXPECT_EQ(a.is_miss(), b.is_miss()) << "ray " << i;
    EXPECT_EQ(alone.occluded[i], together.occluded[i]) << "ray " << i;
    if (a.is_miss() || b.is_miss()) continue;
    ++hits;
    // Both results are Newton's, down to rounding; a grazing ray's slope is a thousandth of the mean slope.
    EXPECT_NEAR(a.t, b.t, 1e-11 * (1 + a.t)) << "ray " << i;
    EXPECT_EQ(a.from_inside, b.from_inside) << "ray " << i;
  }
  // If a ray passes an edge within a rounding, one walk may take a cell that the other leaves out; the same holds for
  // rays in a plane.
  const double cells = static_cast<double>(alone.counters.cells);
  EXPECT_NEAR(static_cast<double>(together.counters.cells), cells, odd_cells * cells + 8);
  EXPECT_EQ(together.counters.uncertified_steps, alone.counters.uncertified_steps);
  return hits;
}

/// Packets of eight rays from about `eye`, apart by `spread`, for each of the targets.
std::vector<Ray> bundles(std::mt19937_64& bits, int count, const Vec3& eye, double spread) {
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto in_cube = [&] { return Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1); };
  std::vector<Ray> rays;
  while (static_cast<int>(rays.size()) < count) {
    const Vec3 target = in_cube() * 0.7;
    for (int i = 0; i < 8; ++i) rays.push_back({eye, (target + in_cube() * spread - eye).normalized(), 4.5, 0, {}});
  }
  return rays;
}

scene::Database flake() {
  return test::sphereflake(2, {scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
}

TEST(Packets, FindWhatSingleRaysFindHoweverFarApartTheyAre) {
  const scene::Database database = flake();
  std::mt19937_64 bits(3);
  for (const double spread : {1e-4, 1e-2, 0.1, 1.0}) {
    SCOPED_TRACE(spread);
    EXPECT_GT(expect_same(database, bundles(bits, 2000, {2.1, 1.3, 1.7}, spread)), 300);
  }
}

TEST(Packets, TakeRaysOfAllDirectionsTogether) {
  const scene::Database database = flake();
  std::mt19937_64 bits(4);
  EXPECT_GT(expect_same(database, bundles(bits, 2000, {0.9, 0.03, 0.01}, 2)), 300);
}

TEST(Packets, TakeRaysAlongTheAxesAndFromWithin) {
  const scene::Database database = flake();
  std::vector<Ray> rays;
  for (int i = 0; i < 40; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double towards : {-1.0, 1.0}) {
        // The origins lie in planes of the grid as well, because its box has round numbers about the origin.
        const int column = i % 8, row = i / 8;
        Vec3 origin(0.05 * column - 0.2, 0.05 * row - 0.1, 0.03 * i - 0.6), direction(0);
        direction[axis] = towards;
        origin[axis] = i % 5 == 0 ? 0 : -2 * towards;
        rays.push_back({origin, direction, 4.5, 0, {}});
      }
    }
  }
  EXPECT_GT(expect_same(database, rays, 0.05), 100);
}

/// Rays that begin on the surface where `rays` hit it: eight that hit it side by side go to one of several lights,
/// along the surface, or anywhere.
std::vector<Ray> leaving(const scene::Database& database, const std::vector<Ray>& rays, std::mt19937_64& bits) {
  const Traced found = traced(database, true, rays);
  const Tracer tracer(database, {});
  TraceCounters counters;
  SurfacePoint surface;
  std::vector<Ray> from_surface;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit& hit = found.hits[i];
    if (hit.is_miss()) continue;
    tracer.surface_at(rays[i], hit, surface, counters);
    const std::size_t packet = i / kPacket;
    const auto any = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
    Vec3 towards = packet % 4 == 0 ? Vec3(any(), any(), any()) : Vec3(3, 5.0 - static_cast<double>(packet % 7), 2);
    if (packet % 4 == 3) towards = towards.cross(surface.normal) + surface.normal * (1e-3 * any());
    Ray ray{surface.position, towards.normalized(), 4.5, 0, {}};
    ray.start = hit.start();
    from_surface.push_back(ray);
  }
  return from_surface;
}

TEST(Packets, TakeRaysThatBeginOnTheSurface) {
  const scene::Database database = flake();
  std::mt19937_64 bits(6);
  for (const double spread : {1e-3, 0.05}) {
    SCOPED_TRACE(spread);
    const std::vector<Ray> rays = leaving(database, bundles(bits, 8000, {2.1, 1.3, 1.7}, spread), bits);
    EXPECT_GT(expect_same(database, rays), 300);
  }
}

TEST(Packets, TakeRaysThatBeginAmongTheBalls) {
  const scene::Database database = flake();
  std::mt19937_64 bits(9);
  const auto any = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
  int from_inside = 0, from_outside = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Ray> rays = bundles(bits, 64, Vec3(any(), any(), any()) * 0.7, 0.3);
    for (Ray& ray : rays) ray.origin += Vec3(any(), any(), any()) * 0.02;
    expect_same(database, rays);
    const Traced found = traced(database, true, rays);
    for (const Hit& hit : found.hits) (hit.from_inside ? from_inside : from_outside) += !hit.is_miss();
  }
  EXPECT_GT(from_inside, 500);
  EXPECT_GT(from_outside, 500);
}

TEST(Packets, TakeRaysThatBeginWherePointsAreCarvedOut) {
  scene::Database database = flake();
  scene::Blob& blob = database.blobs[0];
  std::mt19937_64 bits(8);
  const auto any = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
  for (int i = 0; i < 150; ++i) {
    scene::Component c;
    c.a = Vec3(any(), any(), any()).normalized() * (0.5 + 0.2 * any());
    c.radius_a = 0.06 + 0.03 * any();
    c.strength = -1.5;
    c.kernel = scene::KernelId{0};
    blob.components.push_back(c);
    blob.origins.push_back({});
  }
  const std::vector<Ray> rays = bundles(bits, 8000, {2.1, 1.3, 1.7}, 0.01);
  EXPECT_GT(expect_same(database, rays), 3000);
  EXPECT_GT(expect_same(database, leaving(database, rays, bits)), 300);
}

// Packets leave out what is far from them in long lists, and let rays wait until others have found a cell of their own.
TEST(Packets, FindWhatSingleRaysFindInLongLists) {
  scene::Database database = flake();
  scene::Blob& blob = database.blobs[0];
  std::mt19937_64 bits(21);
  const auto coordinate = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
  for (int i = 0; i < 4000; ++i) {
    scene::Component c;
    c.skeleton = scene::Skeleton::point;
    c.a = Vec3(coordinate(), coordinate(), coordinate());
    c.radius_a = 0.05;
    c.kernel = scene::KernelId{0};
    c.strength = i % 10 == 0 ? -0.5 : 0.25;
    blob.components.push_back(c);
    blob.origins.push_back({});
  }
  for (const double spread : {1e-3, 0.02, 0.3}) {
    SCOPED_TRACE(spread);
    const std::vector<Ray> rays = bundles(bits, 4000, {2.1, 1.3, 1.7}, spread);
    EXPECT_GT(expect_same(database, rays, 0.05), 2000);
    EXPECT_GT(expect_same(database, leaving(database, rays, bits), 0.05), 500);
  }
}

TEST(Packets, TakeEverySkeleton) {
  std::mt19937_64 bits(5);
  for (int which = 0; which < static_cast<int>(scene::Skeleton::plane); ++which) {
    for (const bool is_mapped : {false, true}) {
      scene::Database database = flake();
      scene::Blob& blob = database.blobs[0];
      scene::Transform stretch;
      stretch.matrix.setScale(Vec3(1, 1.5, 0.7));
      stretch.inverse = stretch.matrix.inverse();
      database.transforms.push_back(stretch);
      for (int i = 0; i < 12; ++i) {
        scene::Component c;
        c.skeleton = static_cast<scene::Skeleton>(which);
        c.a = Vec3(0.5 * std::sin(1.7 * i), 0.5 * std::cos(2.3 * i), 0.08 * i - 0.5);
        c.b = has(c.skeleton, scene::kDirectionB) ? Vec3(0, 0.6, 0.8) : c.a + Vec3(0.3, 0.1 * (i % 5), 0.2);
        c.radius_a = 0.05;
        c.radius_b = has(c.skeleton, scene::kDirectionB) ? 0.2 : 0.02;
        c.kernel = scene::KernelId{0};
        if (is_mapped) c.transform = scene::TransformId{0};
        if (has(c.skeleton, scene::kCorner)) {
          c.corner = static_cast<std::uint32_t>(blob.corners.size());
          blob.corners.push_back(c.a + Vec3(-0.1, 0.2, 0.3));
        }
        blob.components.push_back(c);
        blob.origins.push_back({});
      }
      SCOPED_TRACE("skeleton " + std::to_string(which) + (is_mapped ? ", mapped" : ""));
      const std::vector<Ray> rays = bundles(bits, 800, {2.1, 1.3, 1.7}, 0.02);
      EXPECT_GT(expect_same(database, rays), 100);
      EXPECT_GT(expect_same(database, leaving(database, rays, bits)), 10);
    }
  }
}

}  // namespace
}  // namespace isl::render
