#include "renderer/trace/face.h"

#include "renderer/solids/solid.h"

namespace isl::render {
namespace {

using scene::Object;

Vec3 absolute(const Vec3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

struct Shape {
  Object::Kind kind;
  std::uint32_t index;
  double size;
};

Vec3 normal_of(const CompiledScene& scene, const Shape& shape, const SurfacePiece& piece, const Vec3& point,
               const BlobGradient& gradient) {
  if (shape.kind == Object::Kind::blob) {
    const Vec3 g = gradient.at(shape.index, piece.cell, point);
    const double length = g.length();
    return length > 0 && std::isfinite(length) ? g / length : Vec3(0);
  }
  const scene::Solid& solid = scene.solids[shape.index];
  // A solid gives no normal for the missing cap of a tube, but a disc gives one for its plane.
  if (piece.part == kUnseen && !is_part_of_plane(solid)) return Vec3(0);
  return normal_at(solid, piece.part, point, scene.details);
}

/// The face in the shape's own space.
Face face_of_shape(const CompiledScene& scene, const Shape& shape, const SurfacePiece& piece, const Vec3& point,
                   const Vec3& reach, const BlobGradient& gradient) {
  const Vec3 normal = normal_of(scene, shape, piece, point, gradient);
  const Vec3 error = reach + Vec3(shape.size);
  double across = normal == Vec3(0) ? error.length() : absolute(normal).dot(error);
  // The terms of a polynomial cancel, and near a singular point they leave little slope.
  if (shape.kind == Object::Kind::solid) across += terms_over_gradient(scene.solids[shape.index], point, scene.details);
  return {normal, kRounding * across};
}

Face outwards(const Face& face, const scene::Transform& outer_from_inner) {
  const Vec3 normal = outer_from_inner.normal(face.normal);
  const double length = normal.length();
  if (!(length > 0)) return {Vec3(0), face.rounding * length_stretch(outer_from_inner.matrix)};
  return {normal / length, face.rounding / length};
}

}  // namespace

Vec3 reach_through(const scene::Matrix& m, const Vec3& reach) {
  Vec3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] =
        std::abs(m[0][i]) * reach.x + std::abs(m[1][i]) * reach.y + std::abs(m[2][i]) * reach.z + std::abs(m[3][i]);
  }
  return result;
}

Face face_of(const CompiledScene& scene, const CsgLeaf& leaf, const SurfacePiece& piece, const Vec3& point,
             const Vec3& reach, const BlobGradient& gradient) {
  const Shape shape{leaf.kind, leaf.shape, leaf.size};
  if (!leaf.is_placed) return face_of_shape(scene, shape, piece, point, reach, gradient);
  const scene::Transform& map = leaf.group_from_leaf;
  return outwards(
      face_of_shape(scene, shape, piece, map.inverse_point(point), reach_through(map.inverse, reach), gradient), map);
}

Face face_of(const CompiledScene& scene, const Hit& hit, const Vec3& point, const Vec3& reach,
             const BlobGradient& gradient) {
  const Instance& instance = scene.instances[hit.instance];
  const scene::Transform& map = instance.world_from_object;
  const Vec3 local = instance.is_placed ? map.inverse_point(point) : point;
  const Vec3 local_reach = instance.is_placed ? reach_through(map.inverse, reach) : reach;
  const SurfacePiece piece{hit.part, hit.cell};
  const Face face =
      instance.kind == Object::Kind::group
          ? face_of(scene, scene.trees[instance.shape].leaves[hit.leaf], piece, local, local_reach, gradient)
          : face_of_shape(scene, {instance.kind, instance.shape, instance.size}, piece, local, local_reach, gradient);
  return instance.is_placed ? outwards(face, map) : face;
}

}  // namespace isl::render
