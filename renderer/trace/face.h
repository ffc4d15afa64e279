// A face is a piece of surface near a ray: its normal, and how far rounding may have moved it. Two faces that lie no
// farther apart than this coincide. Combinations (csg_search.h), the world (trace/single_trace-inl.h) and `trace`
// (queries/) all use this rule.
//
// The position of a surface is a sum of products: the ray's origin through the maps into the shape's space, the ray's
// step, and the numbers that describe the shape. It takes some 30 roundings of 2⁻⁵³ of the largest of these, so along
// each coordinate of the shape's space rounding moves it by no more than
//   eᵢ = 2⁻⁴⁷ (Σⱼ |Mᵢⱼ| rⱼ + |oᵢ| + size),
// where M and o are the map and its offset, and r is the `reach`: the absolute coordinates that the ray's point was
// added up from. A face with the normal n is moved by |n|·e across itself. In another space the distance is divided by
// the length of the normal that was brought there, so that a flattened shape is known as well as its own coordinates
// are.
#pragma once

#include "renderer/compiled/compiled_scene.h"
#include "renderer/csg/spread.h"
#include "renderer/rays/ray.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

struct Face {
  Vec3 normal{0};       ///< unit length; zero if it is not known
  double rounding = 0;  ///< a distance across the face

  /// The speed at which a ray passes through the face, per unit of t. Without a normal, it is the ray's full speed.
  [[nodiscard]] double slope(const Vec3& direction) const {
    const double length = direction.length();
    return normal == Vec3(0) ? length : std::max(std::abs(normal.dot(direction)), kGrazing * length);
  }
  /// The rounding of t.
  [[nodiscard]] double along(const Vec3& direction) const { return rounding / slope(direction); }
};

/// The gradient of a blob's field, in the blob's space; zero if it is not known.
struct BlobGradient {
  void* context;
  Vec3 (*function)(void* context, std::uint32_t blob, std::uint32_t cell, const Vec3& point);

  [[nodiscard]] Vec3 at(std::uint32_t blob, std::uint32_t cell, const Vec3& point) const {
    return function(context, blob, cell, point);
  }
};

/// A piece of a shape's surface.
struct SurfacePiece {
  std::uint32_t part = 0;             ///< for a solid
  std::uint32_t cell = scene::kNone;  ///< for a blob
};

/// The absolute coordinates that a point of a ray is added up from.
[[nodiscard]] inline Vec3 reach_at(const Vec3& reach, const Vec3& direction, double t) {
  return reach + Vec3(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)) * std::abs(t);
}
/// The reach in the space that the map leads to.
[[nodiscard]] Vec3 reach_through(const scene::Matrix& map, const Vec3& reach);

/// The face of a leaf in the space of the leaf's tree; `point` and `reach` are in that space too.
[[nodiscard]] Face face_of(const CompiledScene& scene, const CsgLeaf& leaf, const SurfacePiece& piece,
                           const Vec3& point, const Vec3& reach, const BlobGradient& gradient);

/// The face where a ray hits an instance, or the same part of its surface at another point; in world space.
[[nodiscard]] Face face_of(const CompiledScene& scene, const Hit& hit, const Vec3& point, const Vec3& reach,
                           const BlobGradient& gradient);

}  // namespace isl::render
