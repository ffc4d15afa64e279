#include "renderer/extents/extents.h"

#include "renderer/extents/blob_extent.h"
#include "renderer/extents/bounding_planes.h"
#include "renderer/extents/povray_blob_box.h"
#include "renderer/scene/group_walk.h"
#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Vec3;

constexpr double kFar = std::numeric_limits<double>::infinity();
const Box kEverything{Vec3(-kFar), Vec3(kFar)};

Box common(const Box& a, const Box& b) {
  Box result;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = std::max(a.min[i], b.min[i]);
    result.max[i] = std::min(a.max[i], b.max[i]);
    if (result.min[i] > result.max[i]) return {};
  }
  return result;
}

/// A box that contains the image of the box. An infinite side makes every side infinite on which it has an influence.
Box mapped(const Box& box, const scene::Transform& transform) {
  if (box.isEmpty()) return {};
  Box result;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = result.max[i] = transform.matrix[3][i];
    for (int j = 0; j < 3; ++j) {
      const double factor = transform.matrix[j][i];
      if (factor == 0) continue;  // 0 times an infinite side would be NaN
      result.min[i] += std::min(factor * box.min[j], factor * box.max[j]);
      result.max[i] += std::max(factor * box.min[j], factor * box.max[j]);
    }
  }
  return result;
}

/// Adds what an object is intersected with if it is a plane. `is_taken_away`: what is left is beyond it.
void add_half_space(const Database& database, const Object& object, bool is_taken_away,
                    std::vector<BoundingPlane>& planes) {
  if (object.kind != Object::Kind::solid) return;
  const scene::Solid& solid = database.solids[object.shape];
  if (solid.kind != scene::SolidKind::plane) return;
  const Vec3 normal = object.parent_from_object.normal(solid.a);
  const double length = normal.length();
  const Vec3 origin(object.parent_from_object.inverse[3][0], object.parent_from_object.inverse[3][1],
                    object.parent_from_object.inverse[3][2]);
  const double distance = solid.radius_a - origin.dot(solid.a), sign = object.inverse != is_taken_away ? -1 : 1;
  planes.push_back({normal * (sign / length), sign * distance / length});
}

/// A box around what is left of space by the planes of an intersection or difference.
Box box_of_planes(const Database& database, const scene::Group& group) {
  std::vector<BoundingPlane> planes;
  bool is_first = true;
  for (const Object& child : group.children) {
    add_half_space(database, child, group.operation == Operation::subtract && !is_first, planes);
    is_first = false;
  }
  return box_around(planes);
}

}  // namespace

bool is_finite(const Box& box) {
  for (int i = 0; i < 3; ++i) {
    if (std::isinf(box.min[i]) || std::isinf(box.max[i])) return false;
  }
  return true;
}

Box Extents::of(const Object& object) { return boxes_of(object).surface; }

Extents::Boxes Extents::boxes_of(const Object& object) {
  Boxes boxes;
  if (object.kind == Object::Kind::solid) {  // tight in the parent's space; the image of a tight box would not be
    const scene::Solid& solid = database_.solids[object.shape];
    boxes.surface = boxes.inside = box_of(database_, solid, object.parent_from_object);
    if (is_part_of_plane(solid)) boxes.inside = kEverything;  // the half-space behind it
  } else {
    boxes = boxes_of_shape(object);
    boxes.surface = mapped(boxes.surface, object.parent_from_object);
    boxes.inside = mapped(boxes.inside, object.parent_from_object);
  }
  if (object.inverse) boxes.inside = kEverything;
  if (object.clip != scene::kNoGroup) {
    const Box clip = mapped(boxes_of_group(index(object.clip)).inside, object.parent_from_object);
    boxes.surface = common(boxes.surface, clip);
    boxes.inside = common(boxes.inside, clip);
  }
  // The scene's `bounded_by` is used only if the surface's own box is not finite.
  if (object.bound != scene::kNoGroup && !is_finite(boxes.surface)) {
    const Box bound = mapped(boxes_of_group(index(object.bound)).inside, object.parent_from_object);
    boxes.surface = common(boxes.surface, bound);
    if (!object.inverse) boxes.inside = common(boxes.inside, bound);
  }
  return boxes;
}

Extents::Boxes Extents::boxes_of_shape(const Object& object) {
  if (object.kind == Object::Kind::group) return boxes_of_group(object.shape);
  const Box& box = box_of_blob_at(object.shape);
  return {box, box};
}

const Box& Extents::box_of_blob_at(std::uint32_t blob) {
  if (blobs_.size() < database_.blobs.size()) blobs_.resize(database_.blobs.size());
  for (std::size_t i = kernels_.size(); i < database_.kernels.size(); ++i)
    kernels_.push_back(kernel_constants(database_.kernels[i]));
  std::optional<Box>& box = blobs_[blob];
  if (!box && rule_ == BoxRule::povray) box = povray_box_of_blob(database_, database_.blobs[blob]);
  if (!box) box = box_of_blob(database_, kernels_, database_.blobs[blob]);
  return *box;
}

Extents::Boxes Extents::boxes_of_group(std::uint32_t group) {
  if (groups_.size() < database_.groups.size()) groups_.resize(database_.groups.size());
  if (groups_[group]) return *groups_[group];
  scene::finish_groups(
      database_, group, [this](std::uint32_t i) { return groups_[i].has_value(); },
      [this](std::uint32_t i) { groups_[i] = boxes_of_children(database_.groups[i]); });
  return *groups_[group];
}

Extents::Boxes Extents::boxes_of_children(const scene::Group& group) {
  const bool is_union = group.operation == Operation::unite || group.operation == Operation::merge;
  Boxes boxes;
  if (!is_union && !group.children.empty()) boxes.inside = kEverything;
  bool is_first = true;
  for (const Object& child : group.children) {
    const Boxes own = boxes_of(child);
    // The surface of any combination consists of parts of the children's surfaces.
    boxes.surface.extendBy(own.surface);
    if (is_union) {
      boxes.inside.extendBy(own.inside);
    } else if (group.operation == Operation::intersect || is_first) {
      boxes.inside = common(boxes.inside, own.inside);
    }
    is_first = false;
  }
  if (!is_union && rule_ == BoxRule::surface && !is_finite(boxes.inside)) {
    boxes.inside = common(boxes.inside, box_of_planes(database_, group));
  }
  if (!is_union) boxes.surface = common(boxes.surface, boxes.inside);
  return boxes;
}

}  // namespace isl::render
