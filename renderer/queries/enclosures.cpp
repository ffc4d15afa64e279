#include "renderer/queries/enclosures.h"

#include "renderer/extents/box_operations.h"
#include "renderer/fields/component_table.h"
#include "renderer/queries/set_logic.h"
#include "renderer/scene/group_walk.h"
#include "renderer/solids/solid.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace isl::render {
namespace {

using Imath::Box3d;
using scene::Object;
using scene::Operation;
using scene::Solid;
using scene::Transform;
using scene::Vec3;

constexpr double kFar = std::numeric_limits<double>::infinity();

Box3d everything() { return {Vec3(-kFar), Vec3(kFar)}; }

double largest_coordinate(const Box3d& box) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(box.min[i]), std::abs(box.max[i])});
  return largest;
}

Box3d widened(Box3d box, double by) {
  if (box.isEmpty()) return box;
  box.min -= Vec3(by);
  box.max += Vec3(by);
  return box;
}

/// The box of a shape in its own space, wider by more than rounding moves the border of a test: that compares lengths
/// which some ten roundings of 2⁻⁵³ made of differences of coordinates, and the box itself was rounded as often. A box
/// that is 2⁻²⁰ of its size wider leaves rounding 2³⁰ times that room, and holds hardly a point more.
Box3d with_margin(const Box3d& box) {
  if (box.isEmpty()) return box;
  const Vec3 size = box.size();
  return widened(box, 0x1p-20 * std::max({size.x, size.y, size.z}) + 0x1p-48 * largest_coordinate(box));
}

/// How far a point near places of this size can be from where its coordinates in the transform's own space come from:
/// p' = p·I are its coordinates there, and p − p'·M = p·(1 − I·M) for the matrix M and what is stored as its inverse I.
/// Infinite if M and I are far from inverse to each other.
double moved_by_rounding(const Transform& transform, double size) {
  const scene::Matrix &m = transform.matrix, &inverse = transform.inverse;
  // Of p' and p'·M, each with 3 products and 3 sums, and of the numbers computed here.
  constexpr double kRounding = 16 * 0x1p-53;
  double growth = 0, offset = 0;
  for (int i = 0; i < 3; ++i) {
    double share = 0;
    for (int j = 0; j < 4; ++j) {
      double product = j == 3 ? m[3][i] : 0, terms = std::abs(product);
      for (int k = 0; k < 3; ++k) {
        product += inverse[j][k] * m[k][i];
        terms += std::abs(inverse[j][k] * m[k][i]);
      }
      const double error = std::abs(product - (j == i ? 1 : 0)) + kRounding * terms;
      if (j < 3) share += error;
      if (j == 3) offset = std::max(offset, error);
    }
    growth = std::max(growth, share);
  }
  // The distance d is at most growth·(size + d) + offset.
  return growth < 0.5 ? 2 * (growth * size + offset) : kFar;
}

/// The box of what is in a box of the transform's own space, however the way there is rounded.
Box3d through(const Transform& transform, const Box3d& box) {
  const Box3d image = box_through(transform, box);
  if (image.isEmpty()) return image;
  const double moved = moved_by_rounding(transform, largest_coordinate(image));
  // An image with infinite sides has no size, and the rounding across its finite ones is not known.
  return moved < kFar ? widened(image, moved) : everything();
}

/// Puts the enclosures of the operands of an "and" (`wants_all`) or an "or" together.
class Operands {
 public:
  explicit Operands(bool wants_all) : wants_all_(wants_all) {}

  void add(const Enclosure& operand) {
    if (operand.beyond == wants_all_) {
      neutral_.extendBy(operand.box);
    } else {
      decisive_ = is_decided_ ? common_box(decisive_, operand.box) : operand.box;
      is_decided_ = true;
    }
  }
  [[nodiscard]] Enclosure enclosure() const {
    return is_decided_ ? Enclosure{decisive_, !wants_all_} : Enclosure{neutral_, wants_all_};
  }

 private:
  bool wants_all_;
  Box3d neutral_;   ///< beyond it, these operands leave the answer to the others
  Box3d decisive_;  ///< beyond it, one of these operands has decided
  bool is_decided_ = false;
};

Enclosure of_solid(const scene::Database& database, const Solid& solid, bool is_inverse) {
  if (is_open_surface(solid)) return {};  // it has neither inside nor outside
  // The sign of a polynomial far from its surface is what rounding leaves of its terms.
  if (is_part_of_plane(solid) || scene::is_polynomial(solid.kind)) return {everything(), false};
  return {with_margin(box_of(database, solid, {})), is_inverse};
}

}  // namespace

Box3d support_box(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
                  const KernelConstants& kernel) {
  scene::Component own = component;
  own.transform = scene::kIdentity;
  static const std::array<Vec3, 6> kDirections{Vec3(-1, 0, 0), Vec3(1, 0, 0),  Vec3(0, -1, 0),
                                               Vec3(0, 1, 0),  Vec3(0, 0, -1), Vec3(0, 0, 1)};
  std::array<std::array<Reach, 2>, kDirections.size()> reaches;
  set_reaches(database, blob, own, kDirections, reaches);
  const double root_q = std::sqrt(kernel.support_q());
  Box3d box;
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    double most = -kFar;
    for (const Reach& end : reaches[i]) most = std::max(most, end.coordinate + root_q * end.radius);
    (i % 2 == 0 ? box.min : box.max)[static_cast<int>(i / 2)] = i % 2 == 0 ? -most : most;
  }
  box = with_margin(box);
  if (component.transform == scene::kIdentity) return box;
  return through(database.transforms[index(component.transform)], box);
}

Enclosure Enclosures::of(const Object& object, bool is_inverse) {
  Enclosure result = of_shape(object, is_inverse != object.inverse);
  if (object.clip != scene::kNoGroup) {
    // The outside of a clipped object is outside the shape or outside the clip.
    Operands operands(!is_inverse);
    operands.add(result);
    operands.add(of_group(index(object.clip))[is_inverse]);
    result = operands.enclosure();
  }
  result.box = through(object.parent_from_object, result.box);
  return result;
}

Enclosure Enclosures::of_shape(const Object& object, bool is_inverse) {
  switch (object.kind) {
    case Object::Kind::solid: return of_solid(database_, database_.solids[object.shape], is_inverse);
    case Object::Kind::blob: {
      const Enclosure blob = of_blob(object.shape);
      return {blob.box, blob.beyond != is_inverse};
    }
    case Object::Kind::group: return of_group(object.shape)[is_inverse];
  }
  ISL_CHECK(false, "object kind {}", static_cast<int>(object.kind));
}

Enclosure Enclosures::of_blob(std::uint32_t blob) {
  if (blobs_.size() < database_.blobs.size()) blobs_.resize(database_.blobs.size());
  std::optional<Enclosure>& known = blobs_[blob];
  if (!known) {
    const scene::Blob& record = database_.blobs[blob];
    known.emplace();
    for (const scene::Component& c : record.components)
      known->box.extendBy(support_box(database_, record, c, kernels_[index(c.kernel)]));
    // A blob whose threshold is 0 or less is where nothing is.
    known->beyond = 0 >= record.threshold && !(record.is_unblended && record.components.empty());
  }
  return *known;
}

const Enclosures::BothWays& Enclosures::of_group(std::uint32_t group) {
  if (groups_.size() < database_.groups.size()) groups_.resize(database_.groups.size());
  if (!groups_[group]) {
    scene::finish_groups(
        database_, group, [this](std::uint32_t i) { return groups_[i].has_value(); },
        [this](std::uint32_t i) {
          const scene::Group& record = database_.groups[i];
          groups_[i] = {of_children(record, false), of_children(record, true)};
        });
  }
  return *groups_[group];
}

Enclosure Enclosures::of_children(const scene::Group& group, bool is_inverse) {
  if (group.children.empty()) return {{}, is_inverse};
  Operands operands(wants_all(group, is_inverse));
  for (std::size_t i = 0; i < group.children.size(); ++i)
    operands.add(of(group.children[i], is_asked_inverse(group, i, is_inverse)));
  return operands.enclosure();
}

}  // namespace isl::render
