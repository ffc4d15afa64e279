#include "tests/support/sphereflake.h"
#include "tests/support/textures.h"

#include <array>
#include <cmath>
#include <numbers>

namespace isl::test {
namespace {

using scene::Vec3;

/// Rotates v about the unit axis (Rodrigues' formula).
Vec3 rotate(const Vec3& v, const Vec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c));
}

/// The nine directions of a sphere's children when the sphere itself points to +z.
std::array<Vec3, 9> child_directions() {
  std::array<Vec3, 9> directions;
  const double radians = std::numbers::pi / 180;
  for (int i = 0; i < 6; ++i) {
    const double azimuth = (15 + 60 * i) * radians;
    directions[i] = {std::cos(azimuth), std::sin(azimuth), 0};
  }
  const double elevation = std::asin(std::sqrt(2.0 / 3.0));
  for (int i = 0; i < 3; ++i) {
    const double azimuth = (45 + 120 * i) * radians;
    directions[6 + i] = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};
  }
  return directions;
}

/// Applies to v the rotation about z × direction that takes +z to `direction` (SPD's rule for the two poles).
Vec3 turned(const Vec3& v, const Vec3& direction) {
  if (direction.z >= 0.9999) return v;
  if (direction.z <= -0.9999) return {-v.x, v.y, -v.z};
  return rotate(v, Vec3(-direction.y, direction.x, 0).normalized(), std::acos(direction.z));
}

void grow(scene::Blob& blob, const std::array<Vec3, 9>& directions, const Vec3& centre, double radius,
          const Vec3& direction, int level, int levels) {
  blob.components.push_back({.a = centre, .radius_a = radius, .texture = scene::TextureId(level)});
  blob.origins.push_back({});
  if (level == levels) return;
  for (const Vec3& v : directions) {
    const Vec3 child = turned(v, direction);
    grow(blob, directions, centre + child * (radius * 4 / 3), radius / 3, child, level + 1, levels);
  }
}

}  // namespace

scene::Database sphereflake(int levels, const scene::Kernel& kernel) {
  scene::Database database;
  database.kernels.push_back(kernel);
  for (int level = 0; level <= levels; ++level) {
    const double light = 1 - std::pow(0.7, level + 1);
    database.textures.push_back(plain_texture(database, {light, light, 1}, {}));
  }
  scene::Blob& blob = database.blobs.emplace_back();
  grow(blob, child_directions(), Vec3(0), 0.5, Vec3(0, 0, 1), 0, levels);
  database.objects.push_back({.kind = scene::Object::Kind::blob, .shape = 0});
  return database;
}

}  // namespace isl::test
