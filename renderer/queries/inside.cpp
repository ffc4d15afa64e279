#include "renderer/queries/inside.h"

#include "base/check.h"
#include "renderer/fields/component_table.h"
#include "renderer/solids/solid.h"

#include <cmath>
#include <vector>

namespace isl::render {

using scene::Component;
using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Solid;

namespace {

/// A database with its kernels, asked about insides. `is_inverse`: the outside is asked for; open surfaces have
/// neither, so that a negation is handed down to the leaves.
class Membership {
 public:
  Membership(const Database& database, const std::vector<KernelConstants>& kernels)
      : database_(database), kernels_(kernels) {}

  /// `point` is in the space that the object is placed into.
  [[nodiscard]] bool holds(const Object& object, bool is_inverse, const Vec3& point) const {
    const Vec3 p = object.parent_from_object.inverse_point(point);
    const bool in_shape = shape_holds(object, is_inverse != object.inverse, p);
    if (object.clip == scene::kNoGroup) return in_shape;
    // The outside of a clipped object is outside the shape or outside the clip.
    const bool in_clip = group_holds(database_.groups[index(object.clip)], is_inverse, p);
    return is_inverse ? in_shape || in_clip : in_shape && in_clip;
  }

 private:
  [[nodiscard]] bool group_holds(const scene::Group& group, bool is_inverse, const Vec3& point) const {
    if (group.children.empty()) return is_inverse;
    const bool is_union = group.operation == Operation::unite || group.operation == Operation::merge;
    const bool wants_all = is_union == is_inverse;
    bool is_first = true;
    for (const Object& child : group.children) {
      const bool is_taken_away = group.operation == Operation::subtract && !is_first;
      if (holds(child, is_inverse != is_taken_away, point) != wants_all) return !wants_all;
      is_first = false;
    }
    return wants_all;
  }

  [[nodiscard]] bool shape_holds(const Object& object, bool is_inverse, const Vec3& point) const {
    switch (object.kind) {
      case Object::Kind::solid: {
        const Solid& solid = database_.solids[object.shape];
        return !is_open_surface(solid) && is_inside(database_, solid, point) != is_inverse;
      }
      case Object::Kind::blob:
        return is_inside(database_, kernels_, database_.blobs[object.shape], point) != is_inverse;
      case Object::Kind::group: return group_holds(database_.groups[object.shape], is_inverse, point);
    }
    ISL_CHECK(false, "object kind {}", static_cast<int>(object.kind));
  }

  const Database& database_;
  const std::vector<KernelConstants>& kernels_;
};

}  // namespace

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
               const Vec3& point) {
  const auto field_of = [&](const Component& c) {
    return field_at(database, blob, c, kernels[index(c.kernel)], point);
  };
  if (blob.is_unblended) {
    return std::ranges::any_of(blob.components, [&](const Component& c) { return field_of(c) >= blob.threshold; });
  }
  std::vector<double> sums(std::max<std::size_t>(blob.branches.size(), 1));
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    sums[blob.branches.empty() ? 0 : blob.branch_of[i]] += field_of(blob.components[i]);
  }
  BranchTree({blob.branches.begin(), blob.branches.end()}).add_up(sums);
  return sums[0] >= blob.threshold;
}

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const Object& object,
               const Vec3& point) {
  return Membership(database, kernels).holds(object, false, point);
}

}  // namespace isl::render
