#include "tests/reference/random_scenes.h"

#include "renderer/reference/reference_kernel.h"
#include "tests/reference/small_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace isl::reference {
namespace {

using scene::Vec3;

scene::Transform rotation(const Vec3& axis, double angle) {
  scene::Transform transform;
  transform.matrix.setAxisAngle(axis, angle);
  transform.inverse = transform.matrix.transposed();
  return transform;
}

/// POV-Ray's kernel, and every shape twice: once with a hardness between 0.5 and 8, and once with the greatest.
std::vector<scene::Kernel> random_kernels(RandomSource& random, double hardest) {
  std::vector<scene::Kernel> kernels = {{scene::KernelShape::quartic, scene::RadiusMeaning::support, 4}};
  for (std::size_t shape = 0; shape < std::size(scene::kKernelWords); ++shape) {
    for (const double hardness : {random.between(0.5, 8), hardest})
      kernels.push_back({static_cast<scene::KernelShape>(shape), scene::RadiusMeaning::surface, hardness});
  }
  return kernels;
}

/// The kernels that can be convolved, in a mode.
std::vector<scene::KernelId> convolved_kernels(scene::Database& database, scene::FieldMode mode) {
  std::vector<scene::KernelId> ids;
  for (std::size_t i = 0, n = database.kernels.size(); i < n; ++i) {
    scene::Kernel kernel = database.kernels[i];
    const bool has_window = kernel.shape == scene::KernelShape::quartic || kernel.shape == scene::KernelShape::cauchy;
    if (!has_window || kernel.meaning != scene::RadiusMeaning::surface) continue;
    kernel.mode = mode;
    ids.push_back(static_cast<scene::KernelId>(database.kernels.size()));
    database.kernels.push_back(kernel);
  }
  return ids;
}

/// Makes a box, a triangle, a circle or a disc of a component whose b is its second end; one box and triangle in four
/// is flat or a needle.
void widen(RandomSource& random, double scale, const scene::Kernel& kernel, scene::Component& c, scene::Blob& blob) {
  const bool thin = random.below(4) == 0;
  const Vec3 aside = random.in_ball(scale * (thin ? 0.005 : 0.5));
  if (c.skeleton == scene::Skeleton::box) {
    const Vec3 end = c.b;
    for (int i = 0; i < 3; ++i) {
      c.b[i] = std::max(c.a[i], end[i]);
      c.a[i] = std::min(c.a[i], end[i]);
    }
    if (const int axis = random.below(3); thin) c.b[axis] = c.a[axis];
  } else if (c.skeleton == scene::Skeleton::triangle) {
    c.corner = static_cast<std::uint32_t>(blob.corners.size());
    blob.corners.push_back((thin ? c.b : c.a) + aside);
  } else {
    c.b = random.direction();
    c.radius_b = scale * random.between(0.1, 0.5);
    if (c.skeleton == scene::Skeleton::disc) return;
    // The field has a crease on the axis, so the support must not reach it.
    const double border = std::sqrt(static_cast<double>(ReferenceKernel(kernel).support().hi()));
    c.radius_a = std::min(c.radius_a, 0.95 * c.radius_b / border);
  }
}

}  // namespace

Vec3 RandomSource::direction() {
  while (true) {
    const Vec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
    const double length = v.length();
    if (length > 0.1 && length <= 1) return v / length;
  }
}

Vec3 RandomSource::in_ball(double radius) {
  const Vec3 towards = direction();
  return towards * (radius * std::cbrt(unit()));
}

LineOfSight random_line(RandomSource& random, double distance, double target) {
  const Vec3 origin = random.direction() * distance;
  return {origin, (random.in_ball(target) - origin).normalized()};
}

std::vector<LineOfSight> random_lines(RandomSource& random, int count, double distance, double target) {
  constexpr int kTogether = 8;
  std::vector<LineOfSight> lines;
  while (true) {
    const bool apart = random.below(3) == 0;
    const LineOfSight first = random_line(random, distance, target);
    const double spread = target * std::pow(10, random.between(-4, 0));
    for (int i = 0; i < kTogether; ++i) {
      if (static_cast<int>(lines.size()) == count) return lines;
      const Vec3 aim = first.direction * distance + random.in_ball(spread);
      lines.push_back(apart ? random_line(random, distance, target) : LineOfSight{first.origin, aim.normalized()});
    }
  }
}

scene::Transform random_transform(RandomSource& random, double shift) {
  Vec3 scale(random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2));
  if (random.below(4) == 0) scale.x = -scale.x;
  scene::Transform scaling, moving;
  scaling.matrix.setScale(scale);
  scaling.inverse.setScale(Vec3(1 / scale.x, 1 / scale.y, 1 / scale.z));
  const Vec3 offset = random.in_ball(shift);
  moving.matrix.setTranslation(offset);
  moving.inverse.setTranslation(-offset);
  const Vec3 axis = random.direction();
  return then(then(scaling, rotation(axis, random.between(0, 3))), moving);
}

scene::Database random_blob(RandomSource& random, const RandomBlobOptions& options) {
  scene::Database database;
  database.kernels = random_kernels(random, options.hardest);
  scene::Blob& blob = database.blobs.emplace_back();
  blob.threshold = random.between(0.3, 1.5);
  for (int i = 0; i < options.components; ++i) {
    scene::Component component;
    component.skeleton = static_cast<scene::Skeleton>(random.below(static_cast<int>(scene::Skeleton::plane)));
    component.kernel = static_cast<scene::KernelId>(random.below(static_cast<int>(database.kernels.size())));
    component.a = random.in_ball(options.scale * 0.7);
    component.b = component.a + random.in_ball(options.scale * 0.5);
    component.radius_a = options.scale * 0.3 * std::pow(10, random.between(-1.5, 0));
    component.radius_b = component.radius_a * random.between(0.2, 1.5);
    if (component.skeleton > scene::Skeleton::cone)
      widen(random, options.scale, database.kernels[index(component.kernel)], component, blob);
    component.strength = random.between(0.5, 3);
    if (options.negatives && random.below(4) == 0) component.strength = -component.strength;
    if (options.transforms && random.below(3) == 0) {
      component.transform = static_cast<scene::TransformId>(database.transforms.size());
      database.transforms.push_back(random_transform(random, options.scale * 0.2));
    }
    blob.components.push_back(component);
    blob.origins.push_back({});
  }
  if (options.half_space) {
    const scene::Vec3 normal = random.direction();
    scene::Component plane = half_space(normal * (-options.scale * random.between(0.2, 1)), normal,
                                        options.scale * random.between(0.02, 0.3));
    plane.kernel = static_cast<scene::KernelId>(1 + random.below(static_cast<int>(database.kernels.size()) - 1));
    plane.strength = random.between(0.5, 2);
    blob.components.push_back(plane);
    blob.origins.push_back({});
  }
  if (options.convolutions) {
    const std::vector<scene::KernelId> windows = convolved_kernels(database, scene::FieldMode::convolution);
    const std::vector<scene::KernelId> sheets = convolved_kernels(database, scene::FieldMode::sheet);
    const auto one_of = [&](const std::vector<scene::KernelId>& ids) {
      return ids[static_cast<std::size_t>(random.below(static_cast<int>(ids.size())))];
    };
    for (scene::Component& c : blob.components) {
      if (c.skeleton == scene::Skeleton::plane) {
        if (random.below(2) == 0) continue;
        c.skeleton = scene::Skeleton::sheet;
        c.kernel = one_of(sheets);
      } else if (c.skeleton == scene::Skeleton::segment || c.skeleton == scene::Skeleton::circle) {
        if (random.below(3) == 0) continue;
        c.kernel = one_of(windows);
        // Rings are at most as wide as their support.
        if (c.skeleton == scene::Skeleton::circle) c.radius_b *= random.between(0.1, 1);
      }
    }
  }
  if (options.maxima) {
    // 0 is the blob's own sum; 1, 2, 3 are alternatives in a maximum, as are 4, 5; inside 2, so are 6 and 7.
    blob.branches = {{0, 0}, {0, 1}, {0, 1}, {0, 1}, {0, 4}, {0, 4}, {2, 6}, {2, 6}};
    for (std::size_t i = 0; i < blob.components.size(); ++i)
      blob.branch_of.push_back(static_cast<std::uint32_t>(random.below(8)));
  }
  scene::Object& object = database.objects.emplace_back();
  object.kind = scene::Object::Kind::blob;
  object.shape = 0;
  return database;
}

}  // namespace isl::reference
