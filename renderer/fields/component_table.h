// A blob's components made ready for evaluation: sorted into groups of one form and one kernel, in a canonical order
// (Morton code, then parameters) so that neither the order in which a scene names them nor the number of threads
// decides a bit of any sum. Everything is in the blob's own space. Made once a blob; read by grid, solvers and shading.
#pragma once

#include "base/check.h"
#include "renderer/fields/branches.h"
#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/fields/skeletons/skeletons.h"
#include "renderer/scene/database.h"

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isl::render {

/// Components begin … end − 1 share skeleton, kernel, and whether they are mapped: a transform that is no similarity
/// stays a map of its own, by which rays and points come into the component's space.
struct FieldGroup {
  bool is_mapped;
  scene::Skeleton skeleton;
  KernelConstants kernel;
  std::uint32_t begin, end;
  std::uint32_t first_shape;  ///< of the first component, among the shapes of its skeleton
  std::uint32_t first_map;    ///< likewise, where is_mapped
};

struct ComponentTable {
  double threshold = 1;
  std::vector<FieldGroup> groups;
  // One row a component.
  std::vector<double> x, y, z;    ///< centre of a point; in its own space if mapped
  std::vector<double> scale;      ///< of a point: v = scale · distance²; of all else: v = scale · q
  std::vector<double> amplitude;  ///< strength times the kernel's
  std::vector<scene::TextureId> texture;
  std::vector<std::uint32_t> source;  ///< index into scene::Blob::components
  bool is_unblended = false;          ///< the blob is the greatest of its fields (scene::Blob::is_unblended)
  std::vector<std::uint32_t> branch;  ///< empty if the blob is one sum, or unblended
  BranchTree tree;
  // What only some have: a row for each component of the skeleton (but points), and for each that is mapped.
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
  /// v of a component = v_scale · q of its skeleton as with_skeleton() gives it: a point's radius is one of v already,
  /// for a rounding less.
  [[nodiscard]] static double v_scale(const FieldGroup& group) {
    return group.skeleton == scene::Skeleton::point ? 1 : group.kernel.scale;
  }
  /// The root of the skeleton's q where the support ends.
  [[nodiscard]] static double support_root(const FieldGroup& group) {
    return std::sqrt(group.kernel.support / v_scale(group));
  }
  /// What `use` makes of the component's skeleton, which has no end.
  template <class Use>
  auto with_endless(const FieldGroup& group, std::uint32_t component, const Use& use) const {
    return with_endless_type(group.skeleton, [&](auto type) {
      return use(shape<typename decltype(type)::type>(group, component));
    });
  }
  /// What `use` makes of the component's skeleton, in its own space.
  template <class Use>
  auto with_skeleton(const FieldGroup& group, std::uint32_t component, const Use& use) const {
    return with_skeleton_type(group.skeleton, [&](auto type) {
      return use(shape<typename decltype(type)::type>(group, component));
    });
  }
};

/// `database` resolves kernels and transforms. Components of strength 0 are left out: they add nothing.
/// `unblended`: draws the blob unblended, whether or not it says so.
[[nodiscard]] ComponentTable compile_components(const scene::Database& database, const scene::Blob& blob,
                                                bool unblended = false);

/// An enclosure of f_component over the box, tight for points; {0, 0} exactly when the support does not reach it. In
/// blob space.
[[nodiscard]] FieldRange field_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                                     const Box& box);

/// A box around the component's support.
[[nodiscard]] Box support_bounds(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

/// Radius of the largest sphere of the skeleton times the root of the support's q: how far the field reaches from its
/// skeleton.
[[nodiscard]] double support_radius(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

/// f of a component at a point of the blob's space, straight from the record (blob: for its corners); `kernel`: its
/// kernel's constants.
[[nodiscard]] double field_at(const scene::Database& database, const scene::Blob& blob,
                              const scene::Component& component, const KernelConstants& kernel, const Vec3& point);

/// No |f| of the component is greater where its q is this or more. Falls with q.
[[nodiscard]] double most_at(const scene::Database& database, const scene::Blob& blob,
                             const scene::Component& component, const KernelConstants& kernel, double q);

/// The greatest value of a convolved component, to a few digits.
[[nodiscard]] double peak_of(const scene::Database& database, const scene::Blob& blob,
                             const scene::Component& component, const KernelConstants& kernel);

/// How far the component comes along n, in the blob's space: of skeleton spheres that hold all of them between them.
[[nodiscard]] std::array<Reach, 2> reach_of(const scene::Database& database, const scene::Blob& blob,
                                            const scene::Component& component, const Vec3& n);

}  // namespace isl::render
