// A point of a level set lies along an outward normal of the skeleton at its nearest point. So for each kind of
// skeleton there is a way of drawing a place on it with one of its normals there; for seams, with a normal on the
// border between those of two features.
#include "tests/conformance/witnesses.h"

#include "tests/reference/random_scenes.h"

#include <array>
#include <cmath>
#include <optional>

namespace isl::conformance {
namespace {

using reference::RandomSource;
using scene::Vec3;

/// The parameters of a draw: the level, and whether the place must be on a seam.
struct Draw {
  RandomSource& random;
  double level;
  bool on_seam;
};

/// A vector of unit length perpendicular to `axis`, which has unit length.
Vec3 across(const Vec3& axis, const Vec3& side) { return (side - axis * side.dot(axis)).normalized(); }

/// A component as spheres along an axis. Its level set q = level² is the envelope of spheres of level times the radius.
/// The set touches each of them where the normal's axial part is −slope·level; where normals lean further outward, it
/// is an end sphere.
struct Limb {
  explicit Limb(const scene::Component& component)
      : a(component.a),
        axis(component.skeleton == scene::Skeleton::point ? Vec3(0) : component.b - component.a),
        radius_a(component.radius_a),
        step(component.skeleton == scene::Skeleton::cone ? component.radius_b - component.radius_a : 0),
        has_axis(axis != Vec3(0)) {
    if (has_axis) {
      along = axis.normalized();
      slope = step / axis.length();
    }
  }
  [[nodiscard]] SurfaceWitness seen_from(double v, const Vec3& direction) const {
    return {a + axis * v, direction, radius_a + step * v};
  }
  /// The normal with that axial part, in the half-plane of `side`.
  [[nodiscard]] Vec3 flank_normal(const Vec3& side, double axial) const {
    return along * axial + across(along, side) * std::sqrt(1 - axial * axial);
  }

  Vec3 a, axis;
  double radius_a, step;
  bool has_axis;
  Vec3 along{0};
  double slope = 0;
};

std::optional<SurfaceWitness> on_limb(const FieldCase& field, const Draw& draw) {
  const Limb limb(field.component);
  const Vec3 direction = draw.random.direction();
  if (!limb.has_axis) return SurfaceWitness{limb.a, direction, limb.radius_a};
  const double end = draw.random.below(2), v = draw.random.unit(), flank = -limb.slope * draw.level;
  if (draw.on_seam && std::abs(flank) < 1) return limb.seen_from(end, limb.flank_normal(direction, flank));
  if (const double lean = direction.dot(limb.along); end == 1 ? lean > flank : lean < flank)
    return limb.seen_from(end, direction);
  if (std::abs(flank) < 1) return limb.seen_from(v, limb.flank_normal(direction, flank));
  return std::nullopt;
}

/// Along each axis the place is on the lower face, on the upper face (the one the normal leans to), or between them.
std::optional<SurfaceWitness> on_box(const FieldCase& field, const Draw& draw) {
  const scene::Component& c = field.component;
  Vec3 centre, normal = draw.random.direction();
  int faces = 0;
  for (int i = 0; i < 3; ++i) {
    const int face = draw.random.below(3);
    centre[i] = face == 0 ? c.a[i] : face == 1 ? c.b[i] : draw.random.between(c.a[i], c.b[i]);
    normal[i] = face == 0 ? -std::abs(normal[i]) : face == 1 ? std::abs(normal[i]) : 0;
    if (face != 2) ++faces;
  }
  if (draw.on_seam) {
    const int axis = draw.random.below(3);
    if (faces < 2 || normal[axis] == 0) return std::nullopt;
    normal[axis] = 0;
  }
  if (normal == Vec3(0)) return std::nullopt;
  return SurfaceWitness{centre, normal.normalized(), c.radius_a};
}

/// A face has two normals, an edge a half circle of normals between those, and a corner all normals that lean away from
/// both of its edges.
std::optional<SurfaceWitness> on_triangle(const FieldCase& field, const Draw& draw) {
  RandomSource& random = draw.random;
  const scene::Component& c = field.component;
  const std::array<Vec3, 3> corners = {c.a, c.b, field.third_corner};
  const int first = random.below(3);
  const Vec3& corner = corners[first];
  const Vec3 edge = corners[(first + 1) % 3] - corner, other = corners[(first + 2) % 3] - corner;
  const Vec3 normal = (c.b - c.a).cross(field.third_corner - c.a).normalized() * (2.0 * random.below(2) - 1);
  const Vec3 outward = across(edge.normalized(), -other);
  const double turn = random.between(0, 1.5);
  const Vec3 about_edge = normal * std::cos(turn) + outward * std::sin(turn);
  const double u = random.unit(), v = random.unit();
  const auto seen_from = [&](const Vec3& centre, const Vec3& direction) {
    return SurfaceWitness{centre, direction.normalized(), c.radius_a};
  };
  const int feature = random.below(3);
  if (draw.on_seam) return feature == 0 ? seen_from(corner, about_edge) : seen_from(corner + edge * u, normal);
  if (feature == 0) return seen_from(corner + edge * (u * (1 - v)) + other * (u * v), normal);
  if (feature == 1) return seen_from(corner + edge * u, about_edge);
  const Vec3 direction = random.direction();
  if (direction.dot(edge) > 0 || direction.dot(other) > 0) return std::nullopt;
  return seen_from(corner, direction);
}

std::optional<SurfaceWitness> on_circle(const FieldCase& field, const Draw& draw) {
  const scene::Component& c = field.component;
  const Vec3 radial = across(c.b, draw.random.direction());
  const double turn = draw.random.between(-3.2, 3.2);
  // Inward, a point twice as far must still be nearer to this side of the circle than to the other.
  if (c.radius_b + 2 * draw.level * c.radius_a * std::cos(turn) < 0) return std::nullopt;
  return SurfaceWitness{c.a + radial * c.radius_b, radial * std::cos(turn) + c.b * std::sin(turn), c.radius_a};
}

/// The face has two normals, the rim a half circle of them between those.
std::optional<SurfaceWitness> on_disc(const FieldCase& field, const Draw& draw) {
  const scene::Component& c = field.component;
  const Vec3 radial = across(c.b, draw.random.direction()), normal = c.b * (2.0 * draw.random.below(2) - 1);
  if (draw.on_seam) return SurfaceWitness{c.a + radial * c.radius_b, normal, c.radius_a};
  if (draw.random.below(2) == 0) {
    return SurfaceWitness{c.a + radial * (c.radius_b * std::sqrt(draw.random.unit())), normal, c.radius_a};
  }
  const double turn = draw.random.between(0, 1.57);
  return SurfaceWitness{c.a + radial * c.radius_b, radial * std::cos(turn) + normal * std::sin(turn), c.radius_a};
}

std::optional<SurfaceWitness> on_plane(const FieldCase& field, const Draw& draw) {
  const scene::Component& c = field.component;
  const bool is_behind = c.skeleton == scene::Skeleton::sheet && draw.random.below(2) == 0;
  const Vec3 place = c.a + across(c.b, draw.random.direction()) * draw.random.unit();
  return SurfaceWitness{place, is_behind ? -c.b : c.b, c.radius_a};
}

std::optional<SurfaceWitness> witness(const FieldCase& field, const Draw& draw) {
  switch (field.component.skeleton) {
    case scene::Skeleton::box: return on_box(field, draw);
    case scene::Skeleton::triangle: return on_triangle(field, draw);
    case scene::Skeleton::circle: return on_circle(field, draw);
    case scene::Skeleton::disc: return on_disc(field, draw);
    case scene::Skeleton::plane:
    case scene::Skeleton::sheet: return on_plane(field, draw);
    default: return on_limb(field, draw);
  }
}

std::vector<SurfaceWitness> witnesses(const FieldCase& field, int count, const Draw& draw) {
  std::vector<SurfaceWitness> drawn;
  while (static_cast<int>(drawn.size()) < count) {
    if (const std::optional<SurfaceWitness> one = witness(field, draw)) drawn.push_back(*one);
  }
  return drawn;
}

}  // namespace

std::vector<SurfaceWitness> surface_witnesses(const FieldCase& field, int count, double level) {
  RandomSource random(7);
  return witnesses(field, count, {random, level, false});
}

std::vector<SurfaceWitness> end_witnesses(const FieldCase& field, int count) {
  RandomSource random(8);
  return witnesses(field, count, {random, 1, true});
}

}  // namespace isl::conformance
