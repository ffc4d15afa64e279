// Boxes beyond which the question whether a point is inside has one answer: outside a sphere's box nothing is in the
// sphere, and everything is in what is its inverse. They are boxes of the tests in inside.h to the last digit, not of
// surfaces: a point that some rounding puts into an object is in its box, too.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isl::render {

struct Enclosure {
  Imath::Box3d box;
  bool beyond = false;  ///< the answer at every point outside the box
};

/// The box beyond which a component's field is exactly 0, in the blob's space.
[[nodiscard]] Imath::Box3d support_box(const scene::Database& database, const scene::Blob& blob,
                                       const scene::Component& component, const KernelConstants& kernel);

/// Finds enclosures; those of shared shapes and groups are computed once. The database may grow during this object's
/// life, but what it holds already must not change. Not thread-safe.
class Enclosures {
 public:
  /// `kernels` are those of the database.
  Enclosures(const scene::Database& database, const std::vector<KernelConstants>& kernels)
      : database_(database), kernels_(kernels) {}

  /// In the space that the object is placed into. `is_inverse`: its outside is asked for.
  [[nodiscard]] Enclosure of(const scene::Object& object, bool is_inverse);

 private:
  /// By `is_inverse`. Open surfaces have neither inside nor outside, so that one does not follow from the other.
  using BothWays = std::array<Enclosure, 2>;

  /// In the object's own space.
  [[nodiscard]] Enclosure of_shape(const scene::Object& object, bool is_inverse);
  [[nodiscard]] Enclosure of_blob(std::uint32_t blob);
  [[nodiscard]] const BothWays& of_group(std::uint32_t group);
  /// The enclosures of all groups that the children refer to are known.
  [[nodiscard]] Enclosure of_children(const scene::Group& group, bool is_inverse);

  const scene::Database& database_;
  const std::vector<KernelConstants>& kernels_;
  std::vector<std::optional<Enclosure>> blobs_;
  std::vector<std::optional<BothWays>> groups_;
};

}  // namespace isl::render
