// Normals are the outward unit gradients, and boxes hold the solid and touch it.
#include "tests/renderer/solids/solid_oracle.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

using scene::Solid;
using scene::SolidKind;

TEST(Normals, are_the_gradient_of_the_gap) {
  Random random(21);
  int checked = 0;
  while (checked < 20000) {
    for (const SolidKind kind : kAllKinds) {
      const Solid solid = random_solid(random, kind);
      const Vec3 direction = random.direction();
      const Vec3 origin = random.in_cube(1.5) - direction * 4.0;
      const Crossings found = crossings(solid, origin, direction, kNoPart);
      for (int i = 0; i < found.count; ++i) {
        const Vec3 point = origin + direction * found.t[i];
        const Vec3 normal = normal_at(solid, found.part[i], point);
        ASSERT_NEAR(normal.length(), 1, 1e-14);
        const double step = 1e-6;
        // Near an edge or an apex the step would cross it, so only the length is checked there.
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
          Vec3 ahead = point, behind = point;
          ahead[axis] += step;
          behind[axis] -= step;
          gradient[axis] =
              static_cast<double>(signed_gap(solid, real(ahead)) - signed_gap(solid, real(behind))) / (2 * step);
        }
        if (std::abs(gradient.length() - 1) > 1e-6) continue;
        ASSERT_LT((normal - gradient).length(), 1e-4) << "kind " << static_cast<int>(kind);
        ++checked;
      }
    }
  }
}

TEST(Normals, at_the_point_of_a_cone_are_its_axis) {
  EXPECT_EQ(normal_at({SolidKind::cone, false, {0, 0, 0}, {0, 2, 0}, 1, 0}, 0, {0, 2, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(normal_at({SolidKind::cone, false, {0, 0, 0}, {0, 2, 0}, 0, 1}, 0, {0, 0, 0}), Vec3(0, -1, 0));
}

TEST(Bounds, hold_every_crossing_and_are_tight) {
  Random random(22);
  for (int i = 0; i < 200; ++i) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone}) {
      const Solid solid = random_solid(random, kind);
      const Box box = bounds(solid);
      for (int axis = 0; axis < 3; ++axis) {
        // Nothing is met just beyond each face of the box; the point that is farthest along the axis lies on the face.
        Vec3 normal(0);
        normal[axis] = 1;
        const Vec3 along_axis = kind == SolidKind::sphere ? Vec3(0) : (solid.b - solid.a).normalized();
        const Vec3 across = normal - along_axis * along_axis[axis];
        const Vec3 rim = across.length() > 1e-9 ? across.normalized() : Vec3(0);
        const double at_a = (solid.a + rim * solid.radius_a)[axis];
        const double radius_b = kind == SolidKind::cylinder ? solid.radius_a : solid.radius_b;
        const double at_b = kind == SolidKind::sphere ? at_a : (solid.b + rim * radius_b)[axis];
        EXPECT_NEAR(box.max[axis], std::max(at_a, at_b), 1e-12);
      }
      for (int ray = 0; ray < 50; ++ray) {
        const Vec3 direction = random.direction();
        const Vec3 origin = random.in_cube(1.5);
        const Crossings found = crossings(solid, origin, direction, kNoPart);
        for (int k = 0; k < found.count; ++k) {
          const Vec3 point = origin + direction * found.t[k];
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(point[axis], box.min[axis] - 1e-12);
            EXPECT_LE(point[axis], box.max[axis] + 1e-12);
          }
        }
      }
    }
  }
}

TEST(Bounds, of_a_plane_are_infinite) {
  const Box box = bounds({SolidKind::plane, false, {0, 1, 0}, Vec3(0), 3, 0});
  EXPECT_TRUE(std::isinf(box.min.x) && box.min.x < 0);
  EXPECT_TRUE(std::isinf(box.max.y) && box.max.y > 0);
}

}  // namespace
}  // namespace isl::render::test
