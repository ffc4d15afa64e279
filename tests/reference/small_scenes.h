// Databases of one blob, made by hand: the vocabulary in which tests state the hard cases.
#pragma once

#include "renderer/scene/database.h"

#include <utility>
#include <vector>

namespace isl::reference {

inline constexpr scene::Kernel kPovRay{scene::KernelShape::quartic, scene::RadiusMeaning::support, 4};

/// A function for each kernel, named by its word: gaussian(4).
#define ISL_KERNEL(word, Type)                                                  \
  [[nodiscard]] constexpr scene::Kernel word(double hardness) {                 \
    return {scene::KernelShape::word, scene::RadiusMeaning::surface, hardness}; \
  }
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL

/// One kernel of each shape.
[[nodiscard]] inline std::vector<scene::Kernel> every_kernel(double hardness) {
  return {
#define ISL_KERNEL(word, Type) word(hardness),
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
  };
}

/// The kernel, integrated along segments and circles. Precondition: a quartic or a cauchy.
[[nodiscard]] constexpr scene::Kernel convolved(scene::Kernel kernel) {
  kernel.mode = scene::FieldMode::convolution;
  return kernel;
}
/// The kernel, integrated over sheets.
[[nodiscard]] constexpr scene::Kernel over_sheets(scene::Kernel kernel) {
  kernel.mode = scene::FieldMode::sheet;
  return kernel;
}

[[nodiscard]] inline scene::Component point(const scene::Vec3& centre, double radius, double strength = 1) {
  scene::Component component;
  component.a = centre;
  component.radius_a = radius;
  component.strength = strength;
  return component;
}

[[nodiscard]] inline scene::Component segment(const scene::Vec3& a, const scene::Vec3& b, double radius,
                                              double strength = 1) {
  scene::Component component = point(a, radius, strength);
  component.b = b;
  component.skeleton = scene::Skeleton::segment;
  return component;
}

[[nodiscard]] inline scene::Component cone(const scene::Vec3& a, double radius_a, const scene::Vec3& b, double radius_b,
                                           double strength = 1) {
  scene::Component component = segment(a, b, radius_a, strength);
  component.radius_b = radius_b;
  component.skeleton = scene::Skeleton::cone;
  return component;
}

[[nodiscard]] inline scene::Component box(const scene::Vec3& low, const scene::Vec3& high, double radius,
                                          double strength = 1) {
  scene::Component component = segment(low, high, radius, strength);
  component.skeleton = scene::Skeleton::box;
  return component;
}

/// A triangle whose third corner is the first of the blob's corners.
[[nodiscard]] inline scene::Component triangle(const scene::Vec3& a, const scene::Vec3& b, double radius,
                                               double strength = 1) {
  scene::Component component = segment(a, b, radius, strength);
  component.skeleton = scene::Skeleton::triangle;
  return component;
}

/// Precondition: `axis` has unit length.
[[nodiscard]] inline scene::Component circle(const scene::Vec3& centre, const scene::Vec3& axis, double ring_radius,
                                             double radius, double strength = 1) {
  scene::Component component = segment(centre, axis, radius, strength);
  component.radius_b = ring_radius;
  component.skeleton = scene::Skeleton::circle;
  return component;
}

/// `axis` has unit length.
[[nodiscard]] inline scene::Component disc(const scene::Vec3& centre, const scene::Vec3& axis, double disc_radius,
                                           double radius, double strength = 1) {
  scene::Component component = circle(centre, axis, disc_radius, radius, strength);
  component.skeleton = scene::Skeleton::disc;
  return component;
}

/// The half-space behind the plane through `at`; `normal` has unit length.
[[nodiscard]] inline scene::Component half_space(const scene::Vec3& at, const scene::Vec3& normal, double radius,
                                                 double strength = 1) {
  scene::Component component = segment(at, normal, radius, strength);
  component.skeleton = scene::Skeleton::plane;
  return component;
}

/// The plane through `at`, convolved, for kernels of the mode sheet. `normal` has unit length.
[[nodiscard]] inline scene::Component sheet(const scene::Vec3& at, const scene::Vec3& normal, double radius,
                                            double strength = 1) {
  scene::Component component = half_space(at, normal, radius, strength);
  component.skeleton = scene::Skeleton::sheet;
  return component;
}

/// One blob in the world, untransformed, all components with the same kernel.
[[nodiscard]] inline scene::Database one_blob(const scene::Kernel& kernel,
                                              const std::vector<scene::Component>& components, double threshold = 1) {
  scene::Database database;
  database.kernels.push_back(kernel);
  scene::Blob& blob = database.blobs.emplace_back();
  blob.threshold = threshold;
  blob.origins.resize(components.size());
  blob.components = GrowingArray<scene::Component>(components);
  scene::Object& object = database.objects.emplace_back();
  object.kind = scene::Object::Kind::blob;
  object.shape = 0;
  return database;
}

/// The blob's parts with `change` made to every place; an axis and a normal are none.
template <class Change>
[[nodiscard]] scene::Database with_places(scene::Database database, const Change& change) {
  scene::Blob& blob = database.blobs.front();
  for (scene::Vec3& corner : blob.corners) change(corner);
  for (scene::Component& component : blob.components) {
    change(component.a);
    if (!has(component.skeleton, scene::kDirectionB)) change(component.b);
  }
  return database;
}

[[nodiscard]] inline scene::Database shifted(scene::Database database, const scene::Vec3& shift) {
  return with_places(std::move(database), [&](scene::Vec3& place) { place += shift; });
}

/// The same blob scaled by a power of two: its picture must scale exactly.
[[nodiscard]] inline scene::Database scaled(scene::Database database, double factor) {
  for (scene::Component& component : database.blobs.front().components) {
    component.radius_a *= factor;
    component.radius_b *= factor;
  }
  return with_places(std::move(database), [&](scene::Vec3& place) { place *= factor; });
}

}  // namespace isl::reference
