// A blob of components of many kinds, for tests that compare two ways to the same bits.
#pragma once

#include "tests/support/sphereflake.h"

#include <cmath>

namespace isl::render {

/// Points, tapered limbs, segments, and negative and stretched components, with both kernels.
[[nodiscard]] inline scene::Database mixed_scene() {
  scene::Database database = test::sphereflake(1, {scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  database.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 3});
  scene::Transform stretch;
  stretch.matrix.setScale(Vec3(1, 1.5, 0.7));
  stretch.inverse = stretch.matrix.inverse();
  database.transforms.push_back(stretch);
  scene::Blob& blob = database.blobs[0];
  for (int i = 0; i < 24; ++i) {
    scene::Component c;
    c.a = Vec3(0.5 * std::sin(1.7 * i), 0.5 * std::cos(2.3 * i), 0.04 * i - 0.5);
    c.b = c.a + Vec3(0.3, 0.1 * (i % 5), -0.2);
    c.radius_a = 0.08;
    c.radius_b = 0.02 + 0.003 * i;
    c.skeleton = static_cast<scene::Skeleton>(i % 3);
    c.kernel = scene::KernelId(i / 2 % 2);
    c.strength = i % 4 == 3 ? -0.5 : 1;
    if (i % 6 == 5) c.transform = scene::TransformId{0};
    blob.components.push_back(c);
    blob.origins.push_back({});
  }
  return database;
}

}  // namespace isl::render
