// Every vector width that this machine has gives the same bits.
#include "renderer/trace/tracer.h"
#include "tests/renderer/trace/mixed_scene.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

namespace isl::render {
namespace {

std::vector<Ray> random_rays(int count) {
  std::mt19937_64 bits(5);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto in_cube = [&] { return Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1); };
  std::vector<Ray> rays;
  while (static_cast<int>(rays.size()) < count) {
    Ray ray;
    ray.origin = in_cube() * 4;
    ray.direction = (in_cube() * 0.8 - ray.origin).normalized();
    rays.push_back(ray);
  }
  return rays;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(SimdTargets, AllGiveTheSameBits) {
  const scene::Database database = mixed_scene();
  const std::vector<Ray> rays = random_rays(3000);
  std::vector<Hit> expected(rays.size());
  TraceCounters counters;
  const Tracer best(database, {});
  best.first_hits(rays, expected, counters);
  int compared = 0, hits = 0;
  for (const char* target : {"AVX3", "AVX2", "SSE4", "SCALAR", "EMU128"}) {
    if (!Tracer::has_simd_target(target)) continue;
    ++compared;
    TracerOptions options;
    options.simd = target;
    const Tracer tracer(database, options);
    std::vector<Hit> found(rays.size());
    tracer.first_hits(rays, found, counters);
    SurfacePoint a, b;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_TRUE(same_bits(found[i].t, expected[i].t)) << target << " ray " << i;
      if (found[i].is_miss()) continue;
      ++hits;
      best.surface_at(rays[i], expected[i], a);
      tracer.surface_at(rays[i], found[i], b);
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_TRUE(same_bits(a.normal[axis], b.normal[axis])) << target << " ray " << i;
    }
  }
  EXPECT_GE(compared, 1);
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace isl::render
