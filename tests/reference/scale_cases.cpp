#include "tests/reference/scale_cases.h"

#include "base/check.h"
#include "renderer/reference/reference_field.h"
#include "tests/reference/small_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::reference {
namespace {

using scene::Skeleton;
using scene::Vec3;

scene::Component component_of(RandomSource& random, Skeleton skeleton, double size, scene::Blob& blob) {
  const Vec3 a = random.in_ball(0.3 * size), b = a + random.direction() * (size * random.between(0.3, 1));
  const double radius = size * random.between(0.1, 0.4);
  switch (skeleton) {
    case Skeleton::point: return point(a, radius);
    case Skeleton::segment: return segment(a, b, radius);
    case Skeleton::cone: return cone(a, radius, b, radius * random.between(0.1, 0.9));
    case Skeleton::box: {
      Vec3 low, high;
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(a[i], b[i]);
        high[i] = std::max(a[i], b[i]);
      }
      return box(low, high, radius);
    }
    case Skeleton::triangle: {
      scene::Component component = triangle(a, b, radius);
      component.corner = static_cast<std::uint32_t>(blob.corners.size());
      blob.corners.push_back(a + random.direction() * size);
      return component;
    }
    // The support stays off the ring's axis, where the field has a crease.
    case Skeleton::circle: return circle(a, random.direction(), size, 0.1 * size);
    case Skeleton::disc: return disc(a, random.direction(), size * random.between(0.3, 1), radius);
    case Skeleton::plane: return half_space(a, random.direction(), radius);
    case Skeleton::sheet: return sheet(a, random.direction(), radius);
  }
  ISL_CHECK(false, "skeleton {}", static_cast<int>(skeleton));
}

/// A point of the component or a little beside it, in its own space.
Vec3 aim_at(RandomSource& random, const scene::Component& c) {
  Vec3 on = c.a;
  if (scene::has(c.skeleton, scene::kPointB | scene::kEndB)) on = c.a + (c.b - c.a) * random.unit();
  if (c.skeleton == Skeleton::circle || c.skeleton == Skeleton::disc) {
    const double share = c.skeleton == Skeleton::disc ? random.unit() : 1;
    on += c.b.cross(random.direction()).normalized() * (c.radius_b * share);
  }
  return on + random.in_ball(1.3 * c.radius_a);
}

}  // namespace

std::string Combination::name() const {
  const char* const mode = kernel.mode == scene::FieldMode::distance ? "" : " convolved";
  return fmt::format("{} {}{} of a {}", scene::kKernelWords[static_cast<std::size_t>(kernel.shape)],
                     kernel.meaning == scene::RadiusMeaning::support ? "(POV-Ray)" : fmt::format("{}", kernel.hardness),
                     mode, scene::kSkeletonWords[static_cast<std::size_t>(skeleton)]);
}

std::vector<Combination> every_combination() {
  std::vector<scene::Kernel> kernels = every_kernel(3);
  const std::vector<scene::Kernel> hard = every_kernel(60);
  kernels.insert(kernels.end(), hard.begin(), hard.end());
  kernels.push_back(quartic(500));
  kernels.push_back(kPovRay);
  return combinations_of(kernels);
}

std::vector<Combination> combinations_of(const std::vector<scene::Kernel>& kernels) {
  std::vector<Combination> all;
  for (const scene::Kernel& kernel : kernels) {
    for (const Skeleton skeleton : {Skeleton::point, Skeleton::segment, Skeleton::cone, Skeleton::box,
                                    Skeleton::triangle, Skeleton::circle, Skeleton::disc, Skeleton::plane}) {
      all.push_back({kernel, skeleton});
    }
    const bool has_window = kernel.shape == scene::KernelShape::quartic || kernel.shape == scene::KernelShape::cauchy;
    if (!has_window || kernel.meaning == scene::RadiusMeaning::support) continue;
    all.push_back({convolved(kernel), Skeleton::segment});
    all.push_back({convolved(kernel), Skeleton::circle});
    all.push_back({over_sheets(kernel), Skeleton::sheet});
  }
  return all;
}

ScaleCase scale_case(RandomSource& random, const Combination& combination, Extreme extreme, int exponent, int lines) {
  const double ratio = std::pow(10, exponent), extent = std::sqrt(ratio);
  const double size = extreme == Extreme::stretched ? 1 : 1 / extent, thin = 1 / extent;
  ScaleCase made{one_blob(combination.kernel, {}), {}, 0};
  scene::Blob& blob = made.database.blobs.front();
  scene::Component small = component_of(random, combination.skeleton, size, blob);
  small.strength = combination.kernel.mode == scene::FieldMode::distance ? random.between(1.5, 3) : 8;
  const bool takes_transform = !scene::is_endless(combination.skeleton);
  Vec3 scale(1);
  if (extreme == Extreme::stretched) {
    scale = {extent, 1, thin};
    if (takes_transform) {
      scene::Transform stretch;
      stretch.matrix.setScale(scale);
      stretch.inverse.setScale(Vec3(1 / scale.x, 1 / scale.y, 1 / scale.z));
      small.transform = static_cast<scene::TransformId>(made.database.transforms.size());
      made.database.transforms.push_back(stretch);
    } else {  // a plane's maps are applied to its record; the plane is thin and its place far along x
      small.radius_a = thin;
    }
  }
  blob.components.push_back(small);
  scene::Component other = point({extent, 0, 0}, extent / 10);
  if (extreme == Extreme::huge) other = point({0, 0, extent + 0.5 * size}, extent);
  // A large ball has a kernel of its own: a convolution has no points.
  if (extreme != Extreme::stretched) {
    other.kernel = static_cast<scene::KernelId>(made.database.kernels.size());
    made.database.kernels.push_back(combination.kernel.mode == scene::FieldMode::distance
                                        ? combination.kernel
                                        : quartic(combination.kernel.hardness));
    blob.components.push_back(other);
  }
  blob.origins.resize(blob.components.size());

  // In the space of the detail the eye is 5 to 10⁷ sizes away, where a coordinate still has eight digits of the detail.
  const double away = std::pow(10, random.between(0.7, 7));
  const double detail = extreme == Extreme::stretched ? thin : size;
  made.pixel_angle = 0.02 / away;
  const Vec3 towards = random.direction();
  for (int i = 0; i < lines; ++i) {
    Vec3 aim = aim_at(random, small);
    if (takes_transform) aim *= scale;
    const Vec3 eye = aim + (towards + random.in_ball(0.3)).normalized() * (away * detail);
    made.lines.push_back({eye, (aim - eye).normalized()});
  }
  return made;
}

SeededScaleCase seeded_scale_case(std::uint64_t seed, int lines) {
  static const std::vector<Combination> kAll = every_combination();
  RandomSource random(seed);
  const Combination& combination = kAll[static_cast<std::size_t>(random.below(static_cast<int>(kAll.size())))];
  const auto extreme = static_cast<Extreme>(random.below(3));
  const int exponent = 6 + random.below(10);
  return {combination, extreme, exponent, scale_case(random, combination, extreme, exponent, lines)};
}

ScaleCase opposed_case(RandomSource& random, const Combination& combination, int lines) {
  ScaleCase made{one_blob(combination.kernel, {}), {}, 1e-3};
  scene::Database& database = made.database;
  scene::Blob& blob = database.blobs.front();
  scene::Component component = component_of(random, combination.skeleton, 1, blob);
  component.strength = random.between(1, 3);
  blob.components.push_back(component);
  blob.origins.resize(1);

  // The ball's field is the same as the component's at a place next to the skeleton, so a surface is close to it. It is
  // no place where a hard field is flat or a spike (within a half-space it is eʰ): there a position says nothing.
  const ReferenceField alone(database, blob);
  const auto is_on_slope = [&](const Vec3& p) {
    const long double value = alone.value({p.x, p.y, p.z});
    return value > 10 && value < 1e6L;
  };
  Vec3 at = aim_at(random, component);
  for (int i = 0; i < 1000 && !is_on_slope(at); ++i) at = aim_at(random, component);
  const double hardness = 200, radius = 0.5;
  const Vec3 centre = at + random.direction() * (radius * random.between(0.2, 0.9));
  scene::Component ball = point(centre, radius);
  ball.kernel = static_cast<scene::KernelId>(database.kernels.size());
  database.kernels.push_back(quartic(hardness));
  const double q = (at - centre).length2() / (radius * radius), depth = 1 + hardness / 2 * (1 - q);
  ball.strength = -static_cast<double>(alone.value({at.x, at.y, at.z})) / (depth * depth);
  blob.components.push_back(ball);
  blob.origins.resize(2);

  for (int i = 0; i < lines; ++i) {
    const Vec3 eye = at + random.direction() * random.between(2, 10);
    const Vec3 aim = at + random.in_ball(0.02);
    made.lines.push_back({eye, (aim - eye).normalized()});
  }
  return made;
}

}  // namespace isl::reference
