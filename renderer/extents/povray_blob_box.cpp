// POV-Ray bounds a blob by the balls about its components' supports, whatever the threshold is: larger than the surface, and scenes
// build on the numbers. By probing POV-Ray 3.7 (tests/cli/program/object_functions_test.cpp has its answers):
//
// A sphere is its own ball. A cylinder has three: one about each cap's end, and one about the middle part. A cylinder stands
// along z from where it is turned by the shortest way. What is turned so, or distorted by a transform, has for its ball's radius
// the greatest half side of the box about the mapped box about the ball; a sphere that is only moved, turned or scaled evenly
// stays the sphere it is. Negative components count for nothing.
// (POV-Ray's cylinder that is turned by a modifier of its own keeps how its axes stood before; here its ends are all that is
// known, and its box can be larger or smaller than POV-Ray's.)
#include "renderer/extents/povray_blob_box.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::render {
namespace {

using Imath::Box3d;
using scene::Component;
using scene::Matrix;
using scene::Vec3;

/// Half a side of the box about the image of the cube [−1, 1]³, along each axis.
Vec3 half_sides(const Matrix& m) {
  Vec3 result(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result[i] += std::abs(m[j][i]);
  }
  return result;
}

double largest(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

/// The factor of a map that moves, turns and scales evenly; nothing for any other.
std::optional<double> even_scale(const Matrix& m) {
  std::array<Vec3, 3> rows;
  for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(i)] = {m[i][0], m[i][1], m[i][2]};
  const double scale2 = rows[0].length2();
  // A product of rotations is even to some units in the last place.
  const double slack = 0x1p-40 * scale2;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(rows[i].length2() - scale2) > slack) return std::nullopt;
    if (std::abs(rows[i].dot(rows[(i + 1) % 3])) > slack) return std::nullopt;
  }
  return std::sqrt(scale2);
}

/// The rotation that takes z to the unit vector `axis` the shortest way.
Matrix from_z(const Vec3& axis) {
  const Vec3 z(0, 0, 1), about = z.cross(axis);
  if (about.length2() == 0) return {};  // along z or against it: the box of a turned cube is the cube
  Matrix rotation;
  return rotation.setAxisAngle(about.normalized(), std::atan2(about.length(), axis.z));
}

class Balls {
 public:
  void add(const Vec3& centre, double radius) {
    box.extendBy(centre - Vec3(radius));
    box.extendBy(centre + Vec3(radius));
  }
  Box3d box;
};

void add_sphere(const Component& c, const scene::Transform& transform, Balls& balls) {
  const double stretch = even_scale(transform.matrix).value_or(largest(half_sides(transform.matrix)));
  balls.add(transform.point(c.a), c.radius_a * stretch);
}

void add_cylinder(const Component& c, const scene::Transform& transform, Balls& balls) {
  const Vec3 along = c.b - c.a;
  const double length = along.length(), half = 0.5 * length;
  const double stretch = largest(half_sides(from_z(along / length) * transform.matrix));
  balls.add(transform.point(c.a), c.radius_a * stretch);
  balls.add(transform.point(c.b), c.radius_a * stretch);
  balls.add(transform.point((c.a + c.b) * 0.5), std::sqrt(half * half + c.radius_a * c.radius_a) * stretch);
}

bool is_povrays(const scene::Database& database, const Component& c) {
  const bool has_word = c.skeleton == scene::Skeleton::point || c.skeleton == scene::Skeleton::segment;
  return has_word && database.kernels[index(c.kernel)].meaning == scene::RadiusMeaning::support;
}

}  // namespace

std::optional<Box3d> povray_box_of_blob(const scene::Database& database, const scene::Blob& blob) {
  if (!blob.branches.empty() || blob.is_unblended) return std::nullopt;
  Balls balls;
  for (const Component& c : blob.components) {
    if (!is_povrays(database, c)) return std::nullopt;
    if (!(c.strength > 0)) continue;
    const scene::Transform transform =
        c.transform == scene::kIdentity ? scene::Transform{} : database.transforms[index(c.transform)];
    if (c.skeleton == scene::Skeleton::point) {
      add_sphere(c, transform, balls);
    } else {
      add_cylinder(c, transform, balls);
    }
  }
  return balls.box;
}

}  // namespace isl::render
