// POV-Ray bounds a blob by balls around its components' supports, whatever the threshold is. The box is larger than the
// surface, and scenes rely on its numbers. The rules below were found by probing POV-Ray 3.7; its answers are in
// tests/cli/program/object_functions_test.cpp.
//
// A sphere is its own ball. A cylinder has three balls: one around each end, and one around the part between. POV-Ray
// defines a cylinder along z and rotates it to its axis the shortest way. If a ball is rotated so, or transformed by a
// map that is no similarity, its radius becomes the greatest half side of the box around the image of its bounding
// cube; a sphere that is moved, rotated or scaled uniformly remains that sphere. Components of negative strength are
// ignored. (If a modifier rotates a cylinder in POV-Ray, the former orientation of its local axes matters. Only the
// cylinder's ends are known here, so its box can be larger or smaller than POV-Ray's.)
#include "renderer/extents/povray_blob_box.h"

#include "renderer/fields/record_skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::render {
namespace {

using Imath::Box3d;
using scene::Component;
using scene::Matrix;
using scene::Vec3;

/// Half sides of the box around the image of the cube [−1, 1]³, along each axis.
Vec3 half_sides(const Matrix& m) {
  Vec3 result(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result[i] += std::abs(m[j][i]);
  }
  return result;
}

double largest(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

/// The scale factor of a similarity; nothing for any other map.
std::optional<double> even_scale(const Matrix& m) {
  std::array<Vec3, 3> rows;
  for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(i)] = {m[i][0], m[i][1], m[i][2]};
  const double scale2 = rows[0].length2();
  // The tolerance is for rounding in products of rotations.
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
  if (about.length2() == 0) return {};  // along ±z: the rotated cube is its own box
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
  for (const Component& record : blob.components) {
    const Component c = simplified(record);
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
