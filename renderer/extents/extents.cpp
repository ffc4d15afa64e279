#include "renderer/extents/extents.h"

#include "renderer/extents/blob_extent.h"
#include "renderer/extents/bounding_planes.h"
#include "renderer/extents/box_operations.h"
#include "renderer/extents/povray_blob_box.h"
#include "renderer/extents/quadric_box.h"
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

/// A box around what the planes of an intersection or difference leave of space.
Box box_of_planes(const Database& database, const scene::Group& group) {
  std::vector<BoundingPlane> planes;
  for (const Object& child : group.children) {
    if (child.kind != Object::Kind::solid) continue;
    const scene::Solid& solid = database.solids[child.shape];
    if (solid.kind != scene::SolidKind::plane) continue;
    const bool is_taken_away = group.operation == Operation::subtract && &child != &group.children.front();
    planes.push_back(bounding_plane(solid, child.parent_from_object, child.inverse != is_taken_away));
  }
  return box_around(planes);
}

/// The part of a box that the quadrics of an intersection or difference may fill, as a box.
Box narrowed_by_quadrics(const Database& database, const scene::Group& group, Box box) {
  for (const Object& child : group.children) {
    if (group.operation == Operation::subtract && &child != &group.children.front()) break;
    if (child.kind != Object::Kind::solid || child.inverse) continue;
    const scene::Solid& solid = database.solids[child.shape];
    if (solid.kind != scene::SolidKind::quadric) continue;
    box = narrowed_by_quadric(box, database.polynomials[solid.detail], child.parent_from_object);
  }
  return box;
}

}  // namespace

bool is_finite(const Box& box) {
  for (int i = 0; i < 3; ++i) {
    if (std::isinf(box.min[i]) || std::isinf(box.max[i])) return false;
  }
  return true;
}

Box Extents::of(const Object& object) { return boxes_of(object).surface; }

Box Extents::inside_of(scene::GroupId group) { return boxes_of_group(index(group)).inside; }

Extents::Boxes Extents::boxes_of(const Object& object) {
  Boxes boxes;
  if (object.kind == Object::Kind::solid) {  // tight in the parent's space; the image of a tight box would not be
    const scene::Solid& solid = database_.solids[object.shape];
    boxes.surface = boxes.inside = box_of(database_, solid, object.parent_from_object);
    if (is_part_of_plane(solid)) boxes.inside = kEverything;  // the half-space behind it
  } else {
    boxes = boxes_of_shape(object);
    boxes.surface = box_through(object.parent_from_object, boxes.surface);
    boxes.inside = box_through(object.parent_from_object, boxes.inside);
  }
  if (object.inverse) boxes.inside = kEverything;
  if (object.clip != scene::kNoGroup) {
    const Box clip = box_through(object.parent_from_object, boxes_of_group(index(object.clip)).inside);
    boxes.surface = common_box(boxes.surface, clip);
    boxes.inside = common_box(boxes.inside, clip);
  }
  // The scene's `bounded_by` is used only if the surface's own box is not finite.
  if (object.bound != scene::kNoGroup && !is_finite(boxes.surface)) {
    const Box bound = box_through(object.parent_from_object, boxes_of_group(index(object.bound)).inside);
    boxes.surface = common_box(boxes.surface, bound);
    if (!object.inverse) boxes.inside = common_box(boxes.inside, bound);
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
      boxes.inside = common_box(boxes.inside, own.inside);
    }
    is_first = false;
  }
  if (!is_union && rule_ == BoxRule::surface && !is_finite(boxes.inside)) {
    boxes.inside = common_box(boxes.inside, box_of_planes(database_, group));
    boxes.inside = narrowed_by_quadrics(database_, group, boxes.inside);
  }
  if (!is_union) boxes.surface = common_box(boxes.surface, boxes.inside);
  return boxes;
}

}  // namespace isl::render
