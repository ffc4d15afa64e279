// Convolved curves have the same field at points, over boxes and along rays.
#include "renderer/fields/component_table.h"
#include "renderer/fields/convolutions/curve_field.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/support/ray_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::render {
namespace {

using reference::RandomSource;

scene::Database convolution(scene::KernelShape shape, double hardness,
                            const std::vector<scene::Component>& components) {
  return reference::one_blob({shape, scene::RadiusMeaning::surface, hardness, scene::FieldMode::convolution},
                             components);
}

/// A segment or a ring; one in three has a map of its own.
scene::Database random_curve(RandomSource& random, int i) {
  const auto shape = i % 2 == 0 ? scene::KernelShape::quartic : scene::KernelShape::cauchy;
  const double radius = random.between(0.1, 0.5);
  scene::Component c =
      i % 4 < 2 ? reference::segment(random.in_ball(0.5), random.in_ball(0.8), radius)
                : reference::circle(random.in_ball(0.3), random.direction(), random.between(0.05, 1), radius);
  c.strength = random.between(-2, 2);
  scene::Database database = convolution(shape, std::pow(10, random.between(-0.5, 1.5)), {c});
  if (i % 3 == 0) {
    database.transforms.push_back(reference::random_transform(random, 0.3));
    database.blobs[0].components[0].transform = scene::TransformId{0};
  }
  return database;
}

struct Curve {
  scene::Database database;
  ComponentTable table = compile_components(database, database.blobs[0]);
  KernelConstants kernel = kernel_constants(database.kernels[0]);

  [[nodiscard]] double value(const Vec3& p) const {
    return field_at(database, database.blobs[0], database.blobs[0].components[0], kernel, p);
  }
};

TEST(ConvolvedField, PointsAndRaysSeeTheSame) {
  RandomSource random(1);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Curve curve{random_curve(random, i)};
    const Vec3 p = random.in_ball(1.5), direction = random.direction() * random.between(0.1, 10);
    const test::RayValue f = test::RayFields(curve.table, p - direction * 0.25, direction, 0.25, 0.25).at(0.25);
    const double value = curve.value(p), noise = 64 * f.noise + 1e-14;
    inside += value != 0 ? 1 : 0;
    EXPECT_NEAR(f.value + curve.table.threshold, value, noise) << i;
    // The slope, by a difference of values on both sides.
    constexpr double kStep = 1e-5;
    const double slope = (curve.value(p + direction * kStep) - curve.value(p - direction * kStep)) / (2 * kStep);
    const double size = f.steepness + std::abs(slope) + std::abs(value);
    // A step across the support's border sees half of the change.
    EXPECT_NEAR(f.slope, slope, 3e-4 * size + 1e-6 * std::abs(curve.table.amplitude[0])) << i;
  }
  EXPECT_GT(inside, 300);
}

TEST(ConvolvedField, GradientIsTheSlopeInEveryDirection) {
  RandomSource random(2);
  for (int i = 0; i < 1000; ++i) {
    const Curve curve{random_curve(random, i)};
    const FieldGroup& group = curve.table.groups.front();
    if (group.is_mapped) continue;
    const Vec3 p = random.in_ball(1.2);
    const CurveSample f = curve.table.with_skeleton(
        group, 0, [&](const auto& skeleton) { return curve_sample(group.kernel, skeleton, p); });
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0);
      step[axis] = 1e-5;
      const double slope = (curve.value(p + step) - curve.value(p - step)) / 2e-5;
      EXPECT_NEAR(curve.table.amplitude[0] * f.gradient[axis], slope,
                  1e-3 * (std::abs(slope) + std::abs(curve.value(p))) + 1e-6);
    }
  }
}

TEST(ConvolvedField, RangeOverABoxHoldsEveryValue) {
  RandomSource random(3);
  int reached = 0;
  for (int i = 0; i < 3000; ++i) {
    const Curve curve{random_curve(random, i)};
    const Vec3 low = random.in_ball(1.2),
               size = Vec3(random.unit(), random.unit(), random.unit()) * std::pow(10, random.between(-2, 0));
    const FieldRange range = field_range(curve.table, curve.table.groups.front(), 0, Box(low, low + size));
    reached += range.low != 0 || range.high != 0 ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      const Vec3 p = low + size * Vec3(random.unit(), random.unit(), random.unit());
      const double value = curve.value(p);
      EXPECT_LE(value, range.high) << i;
      EXPECT_GE(value, range.low) << i;
    }
  }
  EXPECT_GT(reached, 500);
}

TEST(ConvolvedField, NoValueBeyondADistanceExceedsItsBound) {
  RandomSource random(4);
  for (int i = 0; i < 2000; ++i) {
    const Curve curve{random_curve(random, i)};
    const scene::Blob& blob = curve.database.blobs[0];
    const FieldGroup& group = curve.table.groups.front();
    if (group.is_mapped) continue;
    const Vec3 p = random.in_ball(1.2);
    const double q = curve.table.with_skeleton(group, 0, [&](const auto& s) { return s.nearest(p).q(); });
    EXPECT_LE(std::abs(curve.value(p)),
              most_at(curve.database, blob, blob.components[0], curve.kernel, q) * (1 + 1e-12));
    EXPECT_LE(std::abs(curve.value(p)), most_at(curve.database, blob, blob.components[0], curve.kernel, 0.7 * q));
    EXPECT_LE(std::abs(curve.value(p)), peak_of(curve.database, blob, blob.components[0], curve.kernel) * 1.01);
  }
}

TEST(ConvolvedField, BoundsOfARayHoldAndShrinkByEightAHalving) {
  RandomSource random(5);
  double sums[2] = {};
  for (int i = 0; i < 2000; ++i) {
    const Curve curve{random_curve(random, i)};
    const Vec3 origin = random.in_ball(1), direction = random.direction();
    const test::RayFields rays(curve.table, origin, direction, 0, 0.5);
    const double radius = support_radius(curve.table, curve.table.groups.front(), 0);
    for (int half = 0; half < 2; ++half) {
      const double h = 0.02 * radius / (1 + half);
      if (curve.value(origin) != 0 && curve.value(origin + direction * h) != 0)
        sums[half] += rays.remainder(0, h).value / radius;
    }
  }
  EXPECT_GT(sums[0] / sums[1], 8);
}

TEST(ConvolvedField, NothingOfASegmentWithoutLength) {
  const Curve curve{convolution(scene::KernelShape::quartic, 4, {reference::segment({1, 2, 3}, {1, 2, 3}, 0.5)})};
  EXPECT_EQ(curve.table.size(), 0u);
  EXPECT_EQ(curve.value({1, 2, 3}), 0);
}

}  // namespace
}  // namespace isl::render
