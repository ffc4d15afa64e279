// Bounding boxes of the surfaces of objects, for everything that the language can place, drawn or not.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::render {

[[nodiscard]] bool is_finite(const Imath::Box3d& box);

/// Choice of boxes: those around the surfaces, or where POV-Ray's scenes rely on its numbers, those that POV-Ray
/// computes: for a blob of its own components from their supports, and for an intersection of planes from `bounded_by`.
enum class BoxRule : std::uint8_t { surface, povray };

/// Computes boxes of objects; those of shared shapes and groups are computed once. The database may grow during this
/// object's life, but what it holds already must not change.
class Extents {
 public:
  explicit Extents(const scene::Database& database, BoxRule rule = BoxRule::surface)
      : database_(database), rule_(rule) {}

  /// The box of the object's surface in the space that the object is placed into, never smaller than the surface. It is
  /// empty if the object has no surface; a side is infinite if the object is unbounded there, or no bound is known. It
  /// is tight for solids, and for intersections of planes, but not for groups that are rotated as a whole, nor for
  /// other intersections.
  [[nodiscard]] Imath::Box3d of(const scene::Object& object);
  /// A box of all points inside a group, in the group's own space; likewise.
  [[nodiscard]] Imath::Box3d inside_of(scene::GroupId group);

 private:
  struct Boxes {
    Imath::Box3d surface;
    Imath::Box3d inside;  ///< box of all points inside; infinite for an inverse sphere
  };

  [[nodiscard]] Boxes boxes_of(const scene::Object& object);
  [[nodiscard]] Boxes boxes_of_shape(const scene::Object& object);
  [[nodiscard]] Boxes boxes_of_group(std::uint32_t group);
  /// The boxes of all groups that the children refer to are known.
  [[nodiscard]] Boxes boxes_of_children(const scene::Group& group);
  [[nodiscard]] const Imath::Box3d& box_of_blob_at(std::uint32_t blob);

  const scene::Database& database_;
  BoxRule rule_;
  std::vector<KernelConstants> kernels_;
  std::vector<std::optional<Imath::Box3d>> blobs_;
  std::vector<std::optional<Boxes>> groups_;
};

}  // namespace isl::render
