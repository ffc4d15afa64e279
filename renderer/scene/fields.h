// Blobs: components with their kernels.
#pragma once

#include "base/growing_array.h"
#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"
#include "renderer/scene/turn.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isl::scene {

/// The shape of φ(q), q = squared distance to the skeleton over the squared radius.
enum class KernelShape : std::uint8_t {
#define ISL_KERNEL(word, Type) word,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

/// What a scene calls each shape.
inline constexpr std::string_view kKernelWords[] = {
#define ISL_KERNEL(word, Type) #word,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

/// What a component's radius means. `surface`: the radius of the surface that the component has alone (ours: φ(1) = 1,
/// φ′(1) = −hardness). `support`: where the field ends (POV-Ray's own components: φ(q) = (1 − q)², q = 1 at the
/// radius).
enum class RadiusMeaning : std::uint8_t { surface, support };

/// What a kernel is a function of. `distance`: the distance to the skeleton. The other two are of the shapes quartic
/// and cauchy with the surface's radius. `convolution`: it is integrated along the skeleton (a segment or a circle), so
/// that parts of a skeleton add up to the whole; a straight skeleton without end has φ(1) = 1 and φ′(1) = −hardness.
/// `sheet`: it is integrated over a plane without end, with φ(1) = 1 and φ′(1) = −hardness; what comes of it is a
/// function of the distance again.
enum class FieldMode : std::uint8_t { distance, convolution, sheet };

struct Kernel {
  KernelShape shape = KernelShape::quartic;
  RadiusMeaning meaning = RadiusMeaning::support;
  double hardness = 4;  ///< in (0, 500]; without meaning for `support`
  FieldMode mode = FieldMode::distance;
  friend bool operator==(const Kernel&, const Kernel&) = default;
};

/// What a component surrounds. The class of each says what its record means.
enum class Skeleton : std::uint8_t {
#define ISL_SKELETON(word, Type, record) word,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// What a dump calls each.
inline constexpr std::string_view kSkeletonWords[] = {
#define ISL_SKELETON(word, Type, record) #word,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// What the record of a component holds of its skeleton, besides the place `a` and the radius `radius_a`.
enum SkeletonRecord : unsigned {
  kPointB = 1 << 0,             ///< b is another point of it
  kEndB = 1 << 1,               ///< b is a limb's other end; a limb without length is a point
  kDirectionB = 1 << 2,         ///< b is a unit vector
  kRadiusB = 1 << 3,            ///< radius_b is not radius_a
  kCorner = 1 << 4,             ///< Blob::corners[corner] belongs to it
  kTakesSimilarities = 1 << 5,  ///< a rotation, a mirror or an even scaling moves its record, and needs no transform
  kEndless = 1 << 6,            ///< it reaches everywhere across the normal b; every affine map moves its record
};

inline constexpr unsigned kSkeletonRecords[] = {
#define ISL_SKELETON(word, Type, record) record,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// Whether the record of the skeleton holds any of `parts`.
[[nodiscard]] constexpr bool has(Skeleton skeleton, unsigned parts) {
  return (kSkeletonRecords[static_cast<std::size_t>(skeleton)] & parts) != 0;
}
[[nodiscard]] constexpr bool has_b(Skeleton skeleton) { return has(skeleton, kPointB | kEndB | kDirectionB); }

/// Whether it reaches everywhere, in two directions at least.
[[nodiscard]] constexpr bool is_endless(Skeleton skeleton) { return has(skeleton, kEndless); }

/// One field of a blob: f = strength · φ(squared distance / radius²), in the blob's space after `transform`.
struct Component {
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
  double strength = 1;
  TextureId texture = kNoTexture;     ///< kNoTexture: the blob's
  TransformId transform = kIdentity;  ///< blob_from_component
  KernelId kernel{};
  Skeleton skeleton = Skeleton::point;
  std::uint32_t corner = 0;  ///< of what has one: its place in Blob::corners
};

}  // namespace isl::scene

/// Imath's vectors have a copy constructor of their own, which copies their bytes.
template <>
inline constexpr bool isl::kMovesAsBytes<isl::scene::Component> = true;
template <>
inline constexpr bool isl::kMovesAsBytes<isl::scene::Vec3> = true;

namespace isl::scene {

/// A sum of components, and of maxima of branches. A maximum is named by the first of its branches.
struct Branch {
  std::uint32_t parent;   ///< the branch whose sum the maximum belongs to; less than its own number
  std::uint32_t maximum;  ///< the maximum that it is in
};

/// Components whose fields add up; the surface is where the sum meets the threshold. In the blob's own space.
struct Blob {
  double threshold = 1;
  GrowingArray<Component> components;
  GrowingArray<OriginId> origins;   ///< cold: one a component
  GrowingArray<Vec3> corners = {};  ///< third points of what a and b are not enough for
  /// Empty where the blob is one sum. Else the first is the blob's own sum, and branch_of says for each component which
  /// one it is in.
  GrowingArray<Branch> branches = {};
  GrowingArray<std::uint32_t> branch_of = {};
  /// Empty where no component was turned. Else one a component: how, by what is baked into it; for its skeleton
  /// coordinates alone, since its field does not know. Only what takes similarities is turned so.
  GrowingArray<Turn> turns = {};
  /// Unblended: the greatest of the fields instead of their sum, so that each component is the solid that it
  /// is alone. Branches and what carves are left aside.
  bool is_unblended = false;
};

}  // namespace isl::scene
