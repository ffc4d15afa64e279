// Where an object's surface is: the box of anything that the language can place, drawn or not.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::render {

[[nodiscard]] bool is_finite(const Imath::Box3d& box);

/// What counts as the box of a blob whose components are all POV-Ray's own: the one about its surface, or POV-Ray's about their
/// supports, which its scenes build on.
enum class BlobBox : std::uint8_t { surface, povray };

/// Boxes of shared shapes and groups are computed once. The database may grow while this lives; what it holds already
/// must stay as it is.
class Extents {
 public:
  explicit Extents(const scene::Database& database, BlobBox blob_box = BlobBox::surface)
      : database_(database), blob_box_(blob_box) {}

  /// In the space that the object is placed into. Empty where the object has no surface; sides are infinite where it
  /// has no end, or where none is known. Never smaller than the surface; tight for solids, not quite for what is turned
  /// after it was put together, nor for intersections.
  [[nodiscard]] Imath::Box3d of(const scene::Object& object);

 private:
  struct Boxes {
    Imath::Box3d surface;
    Imath::Box3d inside;  ///< of all that is inside: of an inverse sphere everything
  };

  [[nodiscard]] Boxes boxes_of(const scene::Object& object);
  [[nodiscard]] Boxes boxes_of_shape(const scene::Object& object);
  [[nodiscard]] Boxes boxes_of_group(std::uint32_t group);
  [[nodiscard]] const Imath::Box3d& box_of_blob_at(std::uint32_t blob);

  const scene::Database& database_;
  BlobBox blob_box_;
  std::vector<KernelConstants> kernels_;
  std::vector<std::optional<Imath::Box3d>> blobs_;
  std::vector<std::optional<Boxes>> groups_;
};

}  // namespace isl::render
