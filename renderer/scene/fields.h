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

/// The word for each shape in a scene.
inline constexpr std::string_view kKernelWords[] = {
#define ISL_KERNEL(word, Type) #word,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

/// The meaning of a component's radius. `surface`: the radius of the surface of the component alone (kernels of `isl`:
/// φ(1) = 1, φ′(1) = −hardness). `support`: the radius at which the field ends (POV-Ray's own components: φ(q) = (1 −
/// q)², q = 1 at the radius).
enum class RadiusMeaning : std::uint8_t { surface, support };

/// The argument of a kernel. `distance`: the distance to the skeleton. The other two modes exist for the shapes quartic
/// and cauchy with RadiusMeaning::surface. `convolution`: the kernel is integrated along the skeleton (a segment or a
/// circle), so that parts of a skeleton add up to the whole; an infinite straight skeleton has φ(1) = 1 and φ′(1) =
/// −hardness. `sheet`: the kernel is integrated over an infinite plane, with φ(1) = 1 and φ′(1) = −hardness; the
/// integral is again a function of the distance.
enum class FieldMode : std::uint8_t { distance, convolution, sheet };

struct Kernel {
  KernelShape shape = KernelShape::quartic;
  RadiusMeaning meaning = RadiusMeaning::support;
  double hardness = 4;  ///< in (0, 500]; unused for `support`
  FieldMode mode = FieldMode::distance;
  friend bool operator==(const Kernel&, const Kernel&) = default;
};

/// The geometry that a component surrounds. The class of each skeleton documents the meaning of its record.
enum class Skeleton : std::uint8_t {
#define ISL_SKELETON(word, Type, record) word,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// The word for each skeleton in a dump.
inline constexpr std::string_view kSkeletonWords[] = {
#define ISL_SKELETON(word, Type, record) #word,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// The members of a component's record that its skeleton uses, besides the point `a` and the radius `radius_a`.
enum SkeletonRecord : unsigned {
  kPointB = 1 << 0,             ///< b is another point of the skeleton
  kEndB = 1 << 1,               ///< b is the other end of a limb; a limb of length 0 is a point
  kDirectionB = 1 << 2,         ///< b is a unit vector
  kRadiusB = 1 << 3,            ///< radius_b is independent of radius_a
  kCorner = 1 << 4,             ///< Blob::corners[corner] is a third point
  kTakesSimilarities = 1 << 5,  ///< similarities are applied to the record itself, without a transform
  kEndless = 1 << 6,            ///< infinite across the normal b; all affine maps are applied to the record itself
};

inline constexpr unsigned kSkeletonRecords[] = {
#define ISL_SKELETON(word, Type, record) record,
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
};

/// True if the skeleton's record uses any of `parts` (bits of SkeletonRecord).
[[nodiscard]] constexpr bool has(Skeleton skeleton, unsigned parts) {
  return (kSkeletonRecords[static_cast<std::size_t>(skeleton)] & parts) != 0;
}
[[nodiscard]] constexpr bool has_b(Skeleton skeleton) { return has(skeleton, kPointB | kEndB | kDirectionB); }

/// True if the skeleton is infinite in at least two directions.
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
  std::uint32_t corner = 0;  ///< index into Blob::corners; used if the skeleton has kCorner
};

}  // namespace isl::scene

/// Both types are trivially relocatable: Imath's vectors have a copy constructor, which copies their bytes.
template <>
inline constexpr bool isl::kMovesAsBytes<isl::scene::Component> = true;
template <>
inline constexpr bool isl::kMovesAsBytes<isl::scene::Vec3> = true;

namespace isl::scene {

/// A branch: a sum of components and of maxima of further branches. A maximum is named by the first of its branches.
struct Branch {
  std::uint32_t parent;   ///< the branch whose sum has the maximum as a term; less than the branch's own index
  std::uint32_t maximum;  ///< the maximum that the branch is in
};

/// Components whose fields add up; the surface is where the sum meets the threshold. In the blob's own space.
struct Blob {
  double threshold = 1;
  GrowingArray<Component> components;
  GrowingArray<OriginId> origins;   ///< one per component; kept apart, since rays do not need them
  GrowingArray<Vec3> corners = {};  ///< third points of skeletons with kCorner
  /// Empty if the blob is one sum. Otherwise the first branch is the blob's own sum, and branch_of has the index of
  /// each component's branch.
  GrowingArray<Branch> branches = {};
  GrowingArray<std::uint32_t> branch_of = {};
  /// Empty if no component was rotated. Otherwise one per component: the rotation of the similarity that is baked into
  /// it. Only surface coordinates use it, since the field does not depend on it. Only skeletons with kTakesSimilarities
  /// have one.
  GrowingArray<Turn> turns = {};
  /// The field is the greatest of the components' fields instead of their sum, so that each component is drawn as the
  /// solid that it is alone. Branches and components that carve are ignored.
  bool is_unblended = false;
};

}  // namespace isl::scene
