#include "cli/summary/scene_extent.h"

#include "renderer/extents/extents.h"
#include "renderer/scene/group_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace isl::cli {
namespace {

using Imath::Box3d;
using scene::Vec3;

std::array<Vec3, 8> corners(const Box3d& box) {
  std::array<Vec3, 8> result;
  for (int i = 0; i < 8; ++i) {
    result[i] = {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y, (i & 4) ? box.max.z : box.min.z};
  }
  return result;
}

/// Groups share groups, so a short scene may place more objects than a program can visit: the extent of each group is
/// found once, in its own space.
class ExtentBuilder {
 public:
  explicit ExtentBuilder(const scene::Database& database)
      : database_(database), extents_(database), groups_(database.groups.size()) {}

  /// In an unbounded union the bounded objects count: they may stand on a plane.
  SceneExtent of(const std::vector<scene::Object>& objects) {
    SceneExtent extent;
    for (const scene::Object& object : objects) {
      const Box3d box = extents_.of(object);
      if (render::is_finite(box)) {
        extent.box.extendBy(box);
        continue;
      }
      const bool is_group = object.kind == scene::Object::Kind::group;
      if (!is_group || database_.groups[object.shape].operation != scene::Operation::unite) {
        extent.unbounded = true;
        continue;
      }
      const SceneExtent inner = of_group(object.shape);
      extent.unbounded = extent.unbounded || inner.unbounded;
      if (inner.box.isEmpty()) continue;
      for (const Vec3& corner : corners(inner.box)) extent.box.extendBy(object.parent_from_object.point(corner));
    }
    return extent;
  }

 private:
  const SceneExtent& of_group(std::uint32_t group) {
    if (!groups_[group]) {
      scene::finish_groups(
          database_, group, [&](std::uint32_t i) { return groups_[i].has_value(); },
          [&](std::uint32_t i) { groups_[i] = of(database_.groups[i].children); });
    }
    return *groups_[group];
  }

  const scene::Database& database_;
  render::Extents extents_;
  std::vector<std::optional<SceneExtent>> groups_;
};

/// Rounded to a thousandth of the scene's size: a camera's place needs no more.
std::string vector_text(const Vec3& v, double size) {
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 3);
  const auto rounded = [step](double x) { return fmt::format("{:.5g}", std::round(x / step) * step + 0.0); };
  return fmt::format("<{}, {}, {}>", rounded(v.x), rounded(v.y), rounded(v.z));
}

}  // namespace

SceneExtent extent_of(const scene::Database& database) { return ExtentBuilder(database).of(database.objects); }

std::string suggest_camera(const Box3d& box) {
  constexpr double kAngleDegrees = 40;  // of the picture's width; its height then covers three quarters of that
  const double half_height = std::atan(std::tan(kAngleDegrees / 2 * std::numbers::pi / 180) * 3 / 4);
  const double radius = std::max(box.size().length() / 2, std::numeric_limits<double>::min());
  const double distance = radius / std::sin(half_height);
  const Vec3 location = box.center() + Vec3(0.45, 0.35, -0.82).normalized() * distance;
  return fmt::format("camera {{ location {} look_at {} angle {} }}", vector_text(location, radius),
                     vector_text(box.center(), radius), kAngleDegrees);
}

bool may_see(const scene::Camera& camera, const Box3d& box) {
  if (camera.kind != scene::CameraKind::perspective) return true;
  // A point at location + a·direction + b·right + c·up is in the picture if a > 0 and |b|, |c| ≤ a/2. The coordinates
  // are linear, so a box all of whose corners fail the same test lies outside.
  const scene::Matrix world_from_camera(camera.right.x, camera.right.y, camera.right.z, 0, camera.up.x, camera.up.y,
                                        camera.up.z, 0, camera.direction.x, camera.direction.y, camera.direction.z, 0,
                                        camera.location.x, camera.location.y, camera.location.z, 1);
  if (world_from_camera.determinant() == 0) return true;  // Imath's inverse would be the identity
  const scene::Matrix camera_from_world = world_from_camera.inverse();
  std::array<int, 5> outside{};
  for (const Vec3& corner : corners(box)) {
    const Vec3 p = scene::Transform::transformed(corner, camera_from_world);
    outside[0] += p.z <= 0;
    outside[1] += 2 * p.x > p.z;
    outside[2] += 2 * p.x < -p.z;
    outside[3] += 2 * p.y > p.z;
    outside[4] += 2 * p.y < -p.z;
  }
  return std::find(outside.begin(), outside.end(), 8) == outside.end();
}

}  // namespace isl::cli
