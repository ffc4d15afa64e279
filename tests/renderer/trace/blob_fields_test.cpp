// The fields at hits, asked for many at once, have the bits that each has alone, and are those that the sum of one
// point at a time has.
#include "renderer/trace/tracer.h"
#include "tests/renderer/trace/mixed_scene.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace isl::render {
namespace {

/// The components of mixed_scene() and some that are convolved, all of one texture: the same blob three times, of which
/// two are moved.
scene::Database three_mixed_blobs() {
  scene::Database database = mixed_scene();
  const auto convolved = scene::KernelId(static_cast<std::uint32_t>(database.kernels.size()));
  database.kernels.push_back(
      {scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4, scene::FieldMode::convolution});
  int segments = 0;
  for (scene::Component& c : database.blobs[0].components) {
    c.texture = scene::kNoTexture;
    if (c.skeleton == scene::Skeleton::segment && ++segments % 3 == 0) c.kernel = convolved;
  }
  for (const double aside : {-1.5, 1.5}) {
    scene::Object copy = database.objects[0];
    copy.parent_from_object.matrix.setTranslation(Vec3(0, aside, 0));
    copy.parent_from_object.inverse = copy.parent_from_object.matrix.inverse();
    database.objects.push_back(copy);
  }
  return database;
}

struct Seen {
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<std::uint32_t> which;  ///< the rays that hit
};

Seen seen_by_random_rays(const Tracer& tracer, int count) {
  std::mt19937_64 bits(5);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto in_cube = [&] { return Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1); };
  Seen seen;
  while (static_cast<int>(seen.rays.size()) < count) {
    const Vec3 origin = in_cube() * 4, target = in_cube() * Vec3(0.6, 2, 0.6);
    // Some neighbours meet one cell.
    for (int i = 0; i < 3; ++i) {
      Ray ray;
      ray.origin = origin;
      ray.direction = (target + in_cube() * 0.01 - origin).normalized();
      seen.rays.push_back(ray);
    }
  }
  seen.hits.resize(seen.rays.size());
  TraceCounters counters;
  tracer.first_hits(seen.rays, seen.hits, counters);
  for (std::uint32_t i = 0; i < seen.rays.size(); ++i) {
    if (!seen.hits[i].is_miss()) seen.which.push_back(i);
  }
  return seen;
}

bool have_same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(BlobFields, AreTheSameAloneAndTogether) {
  const scene::Database database = three_mixed_blobs();
  const Tracer tracer(database, {});
  const Seen seen = seen_by_random_rays(tracer, 6000);
  ASSERT_GT(seen.which.size(), 1000U);
  std::vector<BlobFields> together(seen.which.size());
  TraceCounters at_once, one_by_one;
  tracer.set_blob_fields(seen.rays, seen.hits, seen.which, together, at_once);
  for (std::size_t i = 0; i < seen.which.size(); ++i) {
    BlobFields alone;
    tracer.set_blob_fields(seen.rays, seen.hits, std::span(seen.which).subspan(i, 1), {&alone, 1}, one_by_one);
    ASSERT_TRUE(have_same_bits(together[i].value, alone.value));
    ASSERT_TRUE(have_same_bits(together[i].magnitude, alone.magnitude));
    for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(have_same_bits(together[i].gradient[axis], alone.gradient[axis]));
    // The surface is there, and F is the threshold to the digits that the solver finds it to.
    EXPECT_NEAR(alone.value, database.blobs[0].threshold, 1e-9 * alone.magnitude);
  }
  EXPECT_EQ(at_once.shading_evaluations, one_by_one.shading_evaluations);
  EXPECT_GT(at_once.shading_evaluations, seen.which.size());
}

/// With a second texture the blob's points are looked at one by one, for the shares of the textures.
TEST(BlobFields, TellTheNormalThatPointByPointSumsTell) {
  scene::Database one = three_mixed_blobs(), two = three_mixed_blobs();
  two.textures.push_back({.pigment = {{0, 1, 0}}});
  two.blobs[0].components.back().texture = scene::TextureId(static_cast<std::uint32_t>(two.textures.size() - 1));
  const Tracer tracer(one, {}), other(two, {});
  const Seen seen = seen_by_random_rays(tracer, 3000);
  ASSERT_GT(seen.which.size(), 500U);
  for (const std::uint32_t i : seen.which) {
    SurfacePoint a, b;
    TraceCounters counters;
    tracer.surface_at(seen.rays[i], seen.hits[i], a, counters);
    Hit hit;
    other.first_hits({&seen.rays[i], 1}, {&hit, 1}, counters);
    ASSERT_FALSE(hit.is_miss());
    other.surface_at(seen.rays[i], hit, b, counters);
    EXPECT_LT((a.normal - b.normal).length(), 1e-8) << "ray " << i;
    EXPECT_FALSE(a.is_refuted);
    EXPECT_EQ(a.textures.size(), 1U);
  }
}

}  // namespace
}  // namespace isl::render
