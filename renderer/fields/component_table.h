// A blob's components made ready for evaluation: sorted into groups of one form and one kernel, in a canonical order
// (Morton code, then parameters), so that every sum is bit for bit independent of the order in which a scene names the
// components and of the number of threads. Everything is in the blob's own space. A table is made once for each blob
// and is read by the grid, the solvers and shading.
#pragma once

#include "base/check.h"
#include "renderer/fields/branches.h"
#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/fields/skeletons/skeletons.h"
#include "renderer/fields/support_balls.h"
#include "renderer/scene/database.h"

#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isl::render {

/// Components begin … end − 1, which share skeleton and kernel and are all mapped or all not. A component is mapped if
/// its transform cannot be baked into its parameters (it is no similarity); rays and points are then transformed into
/// the component's own space.
struct FieldGroup {
  bool is_mapped;
  scene::Skeleton skeleton;
  KernelConstants kernel;
  std::uint32_t begin, end;
  std::uint32_t first_shape;  ///< index of the first component's row among the shapes of its skeleton
  std::uint32_t first_map;    ///< index of the first component's transform in `maps`, if is_mapped
  /// The v at which the first component alone passes the threshold; 0 if it does not. It tells where to look for
  /// surfaces.
  double surface_alone;
};

struct ComponentTable {
  const scene::Database* database = nullptr;  ///< the records that the table was made from; they outlive it
  const scene::Blob* blob = nullptr;
  double threshold = 1;
  std::vector<FieldGroup> groups;
  std::uint32_t plain_points = 0;  ///< the components before this number are points that are not mapped
  // Columns with one row for each component.
  std::vector<double> x, y, z;    ///< the skeleton's middle; in the component's own space if mapped
  std::vector<double> scale;      ///< for a point, v = scale · distance²; for any other skeleton, v = scale · q
  std::vector<double> amplitude;  ///< strength times the kernel's amplitude
  std::vector<scene::TextureId> texture;
  SupportBalls supports;              ///< of the plain points
  bool has_one_texture = true;        ///< all components have the same
  std::vector<std::uint32_t> source;  ///< index into scene::Blob::components
  bool is_unblended = false;          ///< the blob is the greatest of its fields (scene::Blob::is_unblended)
  std::vector<std::uint32_t> branch;  ///< empty if the blob is one sum, or unblended
  BranchTree tree;
  // Columns for some components only: `shapes` has a row for each component that is not a point, by skeleton; `maps`
  // has a row for each mapped component.
  SkeletonColumns shapes;
  std::vector<scene::Transform> maps;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(x.size()); }
  [[nodiscard]] const FieldGroup& group_of(std::uint32_t component) const;
  [[nodiscard]] std::size_t bytes() const;

  template <class Shape>
  [[nodiscard]] Shape shape(const FieldGroup& group, std::uint32_t component) const {
    if constexpr (std::is_same_v<Shape, Point>) {
      return {{x[component], y[component], z[component]}, scale[component]};
    } else {
      return std::get<std::vector<Shape>>(shapes)[component - group.begin + group.first_shape];
    }
  }
  [[nodiscard]] const scene::Transform& blob_from_component(const FieldGroup& group, std::uint32_t component) const {
    return maps[component - group.begin + group.first_map];
  }
  /// v of a component = v_scale · q, with q from the skeleton that with_skeleton() passes. It is 1 for a point, whose
  /// `scale` contains the kernel's factor already: this saves a rounding.
  [[nodiscard]] static double v_scale(const FieldGroup& group) {
    return group.skeleton == scene::Skeleton::point ? 1 : group.kernel.scale;
  }
  /// √q at the border of the support.
  [[nodiscard]] static double support_root(const FieldGroup& group) {
    return std::sqrt(group.kernel.support / v_scale(group));
  }
  /// Calls `use` with the component's skeleton, which must be Endless, and returns its result.
  template <class Use>
  auto with_endless(const FieldGroup& group, std::uint32_t component, const Use& use) const {
    return with_endless_type(group.skeleton,
                             [&](auto type) { return use(shape<typename decltype(type)::type>(group, component)); });
  }
  /// Calls `use` with the component's skeleton, in the component's own space, and returns its result.
  template <class Use>
  auto with_skeleton(const FieldGroup& group, std::uint32_t component, const Use& use) const {
    return with_skeleton_type(group.skeleton,
                              [&](auto type) { return use(shape<typename decltype(type)::type>(group, component)); });
  }
};

/// Upper bound of the bytes that compile_components() holds while it makes the table of a blob.
[[nodiscard]] std::size_t most_table_bytes(const scene::Blob& blob);

/// `database` resolves kernels and transforms. Components of strength 0 are left out: they add nothing.
/// `unblended`: the blob is drawn unblended, even if its record does not say so.
[[nodiscard]] ComponentTable compile_components(const scene::Database& database, const scene::Blob& blob,
                                                bool unblended = false);

/// An enclosure of the component's field over the box, in the blob's space. It is tight for points; {0, 0} exactly when
/// the support does not reach the box.
[[nodiscard]] FieldRange field_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                                     const Box& box);

/// A box, in the blob's space, that contains the component's support.
[[nodiscard]] Box support_bounds(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

/// The greatest distance from the skeleton at which the field is not zero, in the component's own space: the radius of
/// the skeleton's largest sphere times √q at the border of the support.
[[nodiscard]] double support_radius(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

/// The field of a component at a point of the blob's space, computed from its record. `blob` supplies the corners of
/// triangles, `kernel` the constants of the component's kernel.
[[nodiscard]] double field_at(const scene::Database& database, const scene::Blob& blob,
                              const scene::Component& component, const KernelConstants& kernel, const Vec3& point);

/// Upper bound of the component's |f| at all points whose q is at least this. It falls with q.
[[nodiscard]] double most_at(const scene::Database& database, const scene::Blob& blob,
                             const scene::Component& component, const KernelConstants& kernel, double q);

/// The greatest value of a convolved component, to a few digits.
[[nodiscard]] double peak_of(const scene::Database& database, const scene::Blob& blob,
                             const scene::Component& component, const KernelConstants& kernel);

/// The extents of the component along some directions n, in the blob's space: two spheres whose convex hull, seen along
/// n, bounds the skeleton's spheres. `reaches` has room for as many.
void set_reaches(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
                 std::span<const Vec3> directions, std::span<std::array<Reach, 2>> reaches);

}  // namespace isl::render
