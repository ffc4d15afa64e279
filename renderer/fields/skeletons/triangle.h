// A triangle with thickness: q = (squared distance to the triangle)/r².
//
// Space is divided into seven regions by the triangle's nearest feature: the face (between the three planes that stand
// on the edges), an edge (outside its plane, between the two planes across its ends) or a corner. In each the squared
// distance is that to a plane, a line or a point, quadratic along a ray. Pieces meet only on the nine planes.
//
// However thin the triangle is, its distance is right to a few roundings of the coordinates:
// - The normal is perpendicular to the longest edge to rounding. The cross product's error, some 3 roundings over the
//   sine of the largest angle, is left only as a turn about that edge. That moves the third corner by no more than some
//   3 roundings of the shortest edge, and a point above the face, which may so count as one beyond an edge, by less.
// - A point counts as above the face only if it is between the ends of the longest edge. Beyond an acute corner the
//   planes of its two edges alone do not tell: for an angle of 10⁻¹² the rounding of a coordinate is a way of 10⁻⁴.
// - If rounding leaves a point in none of the regions, it is next to some edge, but not always next to the one whose
//   plane it seems to be beyond: each edge of a thin triangle is close to the lines of the others.
//
// Record: the corners a and b, and the index of the third in scene::Blob::corners; radius_a.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct FlatTriangle {
  FlatTriangle(const scene::Blob& blob, const scene::Component& c)
      : corner{c.a, c.b, blob.corners[c.corner]}, radius(c.radius_a) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 edge = corner[(i + 1) % 3] - corner[i];
      length[i] = edge.length();
      along_edge[i] = edge / length[i];
      if (length[i] > length[longest]) longest = i;
    }
    const Vec3 across = along_edge[(longest + 1) % 3].cross(along_edge[(longest + 2) % 3]);
    normal = (across - along_edge[longest] * across.dot(along_edge[longest])).normalized();
    for (int i = 0; i < 3; ++i) outward[i] = along_edge[i].cross(normal);
  }

  Vec3 corner[3];
  double radius;
  Vec3 normal;
  Vec3 along_edge[3];  ///< unit, from corner i to the next
  Vec3 outward[3];     ///< across edge i, out of the triangle and in its plane
  double length[3];
  int longest = 0;  ///< edge

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_a = p - corner[0];
    const Feature feature = nearest_feature(p);
    const double inverse_radius2 = 1 / (radius * radius);
    switch (feature.kind) {
      case Feature::Kind::face: return {normal * from_a.dot(normal), inverse_radius2};
      case Feature::Kind::edge: {
        const Vec3 from_corner = p - corner[feature.index];
        const Vec3& edge = along_edge[feature.index];
        return {from_corner - edge * from_corner.dot(edge), inverse_radius2};
      }
      case Feature::Kind::corner: break;
    }
    return {p - corner[feature.index], inverse_radius2};
  }

  [[nodiscard]] QRange q_over(const Box& box) const {
    return q_range_by_distance(nearest(box.center()).q(), radius, box);
  }

  /// The barycentric coordinates (u, v) of the nearest point A + u (B − A) + v (C − A), as quotients of areas.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    const Vec3 foot = p - nearest(p).offset - corner[0];
    const Vec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0];
    const double area = ab.cross(ac).dot(normal);
    return {std::clamp(foot.cross(ac).dot(normal) / area, 0.0, 1.0),
            std::clamp(ab.cross(foot).dot(normal) / area, 0.0, 1.0)};
  }

  [[nodiscard]] Vec3 middle() const { return corner[0] + ((corner[1] - corner[0]) + (corner[2] - corner[0])) / 3; }
  [[nodiscard]] double extent() const {
    double square = 0;
    for (const Vec3& c : corner) square = std::max(square, (c - middle()).length2());
    return std::sqrt(square);
  }
  [[nodiscard]] double thickest() const { return radius; }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double coordinate = std::max({n.dot(corner[0]), n.dot(corner[1]), n.dot(corner[2])});
    return {Reach{coordinate, radius}, Reach{coordinate, radius}};
  }

  static constexpr std::size_t kMostPieces = 10;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    Breaks<9> breaks;
    for (int i = 0; i < 3; ++i) {
      const Vec3 from_corner = origin - corner[i];
      breaks.add(from_corner.dot(outward[i]), direction.dot(outward[i]), 0);
      const double x = from_corner.dot(along_edge[i]), dx = direction.dot(along_edge[i]);
      breaks.add(x, dx, 0);
      breaks.add(x, dx, length[i]);
    }
    const double inverse_radius2 = 1 / (radius * radius);
    breaks.for_each([&](double begin, double end, double inside) {
      const Feature feature = nearest_feature(origin + direction * inside);
      if (feature.kind == Feature::Kind::corner) {
        return emit(sphere_piece(corner[feature.index], inverse_radius2, origin, direction, begin, end));
      }
      // The part of the ray that changes the distance: along the normal of the face, or across the edge.
      const Vec3 from_corner = origin - corner[feature.index];
      Vec3 from, by;
      if (feature.kind == Feature::Kind::face) {
        from = normal * from_corner.dot(normal);
        by = normal * direction.dot(normal);
      } else {
        const Vec3& edge = along_edge[feature.index];
        from = from_corner - edge * from_corner.dot(edge);
        by = direction - edge * direction.dot(edge);
      }
      emit(distance_piece(from, by, inverse_radius2, begin, end));
    });
  }

 private:
  struct Feature {
    enum class Kind { face, edge, corner } kind;
    int index;
  };

  [[nodiscard]] Feature nearest_feature(const Vec3& p) const {
    bool is_within = true;
    double place[3], side[3];  // along and across the edges
    for (int i = 0; i < 3; ++i) {
      const Vec3 from_corner = p - corner[i];
      place[i] = from_corner.dot(along_edge[i]);
      side[i] = from_corner.dot(outward[i]);
      is_within = is_within && side[i] <= 0;
    }
    if (is_within && place[longest] >= 0 && place[longest] <= length[longest]) return {Feature::Kind::face, 0};
    for (int i = 0; i < 3; ++i) {
      if (side[i] > 0 && place[i] > 0 && place[i] < length[i]) return {Feature::Kind::edge, i};
    }
    return nearest_of_edges(p, place);
  }

  /// A corner or an edge. Not inlined: most points have been decided before.
  [[nodiscard, gnu::noinline]] Feature nearest_of_edges(const Vec3& p, const double (&place)[3]) const {
    Feature nearest{Feature::Kind::corner, 0};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const double foot = std::clamp(place[i], 0.0, length[i]);
      const double distance2 = (p - corner[i] - along_edge[i] * foot).length2();
      if (!(distance2 < least)) continue;
      least = distance2;
      if (foot > 0 && foot < length[i]) {
        nearest = {Feature::Kind::edge, i};
      } else {
        nearest = {Feature::Kind::corner, foot > 0 ? (i + 1) % 3 : i};
      }
    }
    return nearest;
  }
};

}  // namespace isl::render
