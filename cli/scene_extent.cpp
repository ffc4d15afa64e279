// The box of a blob. Along a direction n, the sum of what every component can reach anywhere in the half-space n·p ≥ a
// bounds the field there from above, and falls as a grows. Where it meets the threshold no surface lies beyond: found
// by bisection for the six directions of the axes. A component alone gives the bracket: its support ends outside, its
// own surface inside.
#include "cli/scene_extent.h"

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/solids/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace isl::cli {
namespace {

using Imath::Box3d;
using render::KernelConstants;
using scene::Component;
using scene::Database;
using scene::Object;
using scene::Vec3;

/// φ(q): kernel_constants.h has the formulas.
double kernel_value(const KernelConstants& kernel, double q) {
  const double v = kernel.scale * q;
  if (v >= kernel.support) return 0;
  if (kernel.shape == scene::KernelShape::quartic) return kernel.amplitude * (1 - v) * (1 - v);
  return kernel.amplitude * (std::exp(kernel.a - v) - kernel.cut * (1 + kernel.support - v));
}

/// A component seen along one direction: its two ends' coordinates, and what one radius measures there.
struct Profile {
  const KernelConstants* kernel = nullptr;
  double strength = 0;
  std::array<double, 2> end{};
  std::array<double, 2> radius{};

  /// The most that the component reaches in the half-space beyond `a`. Between the ends coordinate and radius are
  /// linear, so their quotient is monotone and an end has its least value.
  [[nodiscard]] double most_beyond(double a) const {
    double root_q = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      if (end[i] >= a) return strength * kernel_value(*kernel, 0);
      if (radius[i] > 0) root_q = std::min(root_q, (a - end[i]) / radius[i]);
    }
    return strength * kernel_value(*kernel, root_q * root_q);
  }
  [[nodiscard]] double support_end() const {
    const double reach = std::sqrt(kernel->support_q());
    return std::max(end[0] + reach * radius[0], end[1] + reach * radius[1]);
  }
};

Profile profile_of(const Database& database, const std::vector<KernelConstants>& kernels, const Component& c, int axis,
                   double sign) {
  static const scene::Transform kSame;
  const scene::Transform& blob_from_component =
      c.transform == scene::kIdentity ? kSame : database.transforms[index(c.transform)];
  const scene::Matrix& m = blob_from_component.matrix;
  const double stretch = Vec3(m[0][axis], m[1][axis], m[2][axis]).length();
  const bool is_point = c.skeleton == scene::Skeleton::point;
  const Vec3 b = is_point ? c.a : c.b;
  const double radius_b = c.skeleton == scene::Skeleton::cone ? c.radius_b : c.radius_a;
  Profile profile;
  profile.kernel = &kernels[index(c.kernel)];
  profile.strength = c.strength;
  profile.end = {sign * blob_from_component.point(c.a)[axis], sign * blob_from_component.point(b)[axis]};
  profile.radius = {c.radius_a * stretch, radius_b * stretch};
  return profile;
}

double sum_beyond(std::span<const Profile> profiles, double a) {
  double sum = 0;
  for (const Profile& profile : profiles) sum += profile.most_beyond(a);
  return sum;
}

/// The least a beyond which the blob has no surface, or nothing when it has none at all.
std::optional<double> reach(std::vector<Profile>& profiles, double threshold) {
  double low = std::numeric_limits<double>::infinity();  // the sum over half-spaces from here on reaches the threshold
  double high = -low;                                    // no support reaches here
  for (const Profile& profile : profiles) {
    low = std::min({low, profile.end[0], profile.end[1]});
    high = std::max(high, profile.support_end());
  }
  if (!(sum_beyond(profiles, low) >= threshold)) return std::nullopt;
  for (const Profile& profile : profiles) {  // components that have a surface alone bring `low` up at once
    const double own = std::max(profile.end[0], profile.end[1]);
    if (own > low && profile.most_beyond(own) >= threshold) low = own;
  }
  std::erase_if(profiles, [low](const Profile& profile) { return profile.support_end() <= low; });
  constexpr int kSteps = 24;  // 2⁻²⁴ of a radius: beyond what a printed box shows
  for (int step = 0; step < kSteps; ++step) {
    const double middle = low + (high - low) / 2;
    (sum_beyond(profiles, middle) >= threshold ? low : high) = middle;
  }
  return high;
}

Box3d box_of_blob(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob) {
  Box3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      std::vector<Profile> profiles;
      for (const Component& c : blob.components) {
        if (c.strength > 0) profiles.push_back(profile_of(database, kernels, c, axis, sign));
      }
      const std::optional<double> a = profiles.empty() ? std::nullopt : reach(profiles, blob.threshold);
      if (!a) return {};
      (sign < 0 ? box.min : box.max)[axis] = sign * *a;
    }
  }
  return box;
}

std::array<Vec3, 8> corners(const Box3d& box) {
  std::array<Vec3, 8> result;
  for (int i = 0; i < 8; ++i) {
    result[i] = {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y, (i & 4) ? box.max.z : box.min.z};
  }
  return result;
}

/// Boxes of shared shapes and groups, each computed once.
class Extents {
 public:
  explicit Extents(const Database& database)
      : database_(database), blobs_(database.blobs.size()), groups_(database.groups.size()) {
    for (const scene::Kernel& kernel : database.kernels) kernels_.push_back(render::kernel_constants(kernel));
  }

  SceneExtent of(std::span<const Object> objects) {
    SceneExtent extent;
    for (const Object& object : objects) {
      const SceneExtent own = of_shape(object);
      extent.unbounded |= own.unbounded;
      if (own.box.isEmpty()) continue;
      for (const Vec3& corner : corners(own.box)) extent.box.extendBy(object.parent_from_object.point(corner));
    }
    return extent;
  }

 private:
  SceneExtent of_shape(const Object& object) {
    switch (object.kind) {
      case Object::Kind::solid: {
        const scene::Solid& solid = database_.solids[object.shape];
        if (solid.kind == scene::SolidKind::plane) return {{}, true};
        return {render::bounds(solid), false};
      }
      case Object::Kind::blob: {
        std::optional<Box3d>& box = blobs_[object.shape];
        if (!box) box = box_of_blob(database_, kernels_, database_.blobs[object.shape]);
        return {*box, false};
      }
      case Object::Kind::group: break;
    }
    std::optional<SceneExtent>& extent = groups_[object.shape];
    if (!extent) extent = of(database_.groups[object.shape].children);
    return *extent;
  }

  const Database& database_;
  std::vector<KernelConstants> kernels_;
  std::vector<std::optional<Box3d>> blobs_;
  std::vector<std::optional<SceneExtent>> groups_;
};

/// Rounded to a thousandth of the scene's size: a place to stand, not a measurement.
std::string vector_text(const Vec3& v, double size) {
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 3);
  const auto rounded = [step](double x) { return fmt::format("{:.5g}", std::round(x / step) * step + 0.0); };
  return fmt::format("<{}, {}, {}>", rounded(v.x), rounded(v.y), rounded(v.z));
}

}  // namespace

SceneExtent extent_of(const Database& database) { return Extents(database).of(database.objects); }

std::string suggest_camera(const Box3d& box) {
  constexpr double kAngleDegrees = 40;  // of the picture's width; its height then takes in three quarters of that
  const double half_height = std::atan(std::tan(kAngleDegrees / 2 * std::numbers::pi / 180) * 3 / 4);
  const double radius = std::max(box.size().length() / 2, std::numeric_limits<double>::min());
  const double distance = radius / std::sin(half_height);
  const Vec3 location = box.center() + Vec3(0.45, 0.35, -0.82).normalized() * distance;
  return fmt::format("camera {{ location {} look_at {} angle {} }}", vector_text(location, radius),
                     vector_text(box.center(), radius), kAngleDegrees);
}

bool may_see(const scene::Camera& camera, const Box3d& box) {
  // A point at location + a·direction + b·right + c·up is in the picture where a > 0 and |b|, |c| ≤ a/2. The
  // coordinates are linear, so a box all of whose corners fail the same test lies outside.
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
