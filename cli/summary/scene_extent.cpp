#include "cli/summary/scene_extent.h"

#include "renderer/extents/extents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

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

class ExtentBuilder {
 public:
  ExtentBuilder(const scene::Database& database, SceneExtent& extent)
      : database_(database), extents_(database), extent_(extent) {}

  /// In an unbounded union the bounded objects count: they may stand on a plane. Unions wait in a list, so that depth
  /// costs no stack.
  void add(const std::vector<scene::Object>& world) {
    std::vector<Placed> pending{{&world, {}}};
    while (!pending.empty()) {
      const Placed next = pending.back();
      pending.pop_back();
      for (const scene::Object& object : *next.objects) {
        scene::Object placed = object;
        placed.parent_from_object = then(object.parent_from_object, next.world_from_parent);
        const Box3d box = extents_.of(placed);
        if (render::is_finite(box)) {
          extent_.box.extendBy(box);
          continue;
        }
        const bool is_group = object.kind == scene::Object::Kind::group;
        if (is_group && database_.groups[object.shape].operation == scene::Operation::unite) {
          pending.push_back({&database_.groups[object.shape].children, placed.parent_from_object});
        } else {
          extent_.unbounded = true;
        }
      }
    }
  }

 private:
  struct Placed {
    const std::vector<scene::Object>* objects;
    scene::Transform world_from_parent;
  };

  const scene::Database& database_;
  render::Extents extents_;
  SceneExtent& extent_;
};

/// Rounded to a thousandth of the scene's size: a camera's place needs no more.
std::string vector_text(const Vec3& v, double size) {
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 3);
  const auto rounded = [step](double x) { return fmt::format("{:.5g}", std::round(x / step) * step + 0.0); };
  return fmt::format("<{}, {}, {}>", rounded(v.x), rounded(v.y), rounded(v.z));
}

}  // namespace

SceneExtent extent_of(const scene::Database& database) {
  SceneExtent extent;
  ExtentBuilder(database, extent).add(database.objects);
  return extent;
}

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
