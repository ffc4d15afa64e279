// The interface of skeletons. A skeleton is a set of spheres, all of one radius or of a radius that changes along the
// skeleton; the field's argument q at a point is the least quotient of the squared distance to a centre and that
// sphere's squared radius. A skeleton is a class, in its component's own space, which is constructed from a record (and
// its blob, for data that does not fit into the record), with
//
//   Foot nearest(p)                      the sphere with the least quotient
//   QRange q_over(box)                   an enclosure of q
//   std::array<Reach, 2> reach(n)        its extent along n: two spheres whose convex hull has the same extent
//   double thickest(), thinnest()        the largest radius; the smallest, if that is different
//   Vec3 middle(); double extent()       a point amidst it, and how far from there its own points are at most; those of
//                                        an endless skeleton are not counted
//   Coordinates coordinates(p, turn)     (u, v): along the skeleton from 0 to 1, and around it; the skeleton was turned
//                                        by `turn` after it had its coordinates (scene::Blob::turns)
//
// a row in renderer/scene/skeletons.def, and one of two ways to evaluate q along a ray:
//
//   void along(origin, direction, emit)  q along a ray, in no more than kMostPieces quadratic pieces
//   a ray form (ray_form-inl.h)          for q that is not a quadratic: a second part of its file, compiled for every
//                                        SIMD target. A class OnRay may accompany it, which gives the published
//                                        solver the interval of a ray where q < c, below(c), and the least q, least();
//                                        without that class the solver samples the ray.
#pragma once

#include "renderer/scene/fields.h"
#include "renderer/solids/surface_coordinates.h"

#include <ImathBox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace isl::render {

using Box = Imath::Box3d;

struct Foot {
  Vec3 offset;             ///< from the sphere's centre to the point
  double inverse_radius2;  ///< 1/r² of the sphere

  [[nodiscard]] double q() const { return offset.length2() * inverse_radius2; }
};

struct QRange {
  double low, high;
};

struct Reach {
  double coordinate;  ///< position of a centre along n
  double radius;
};

/// A stretch of a ray, empty unless begin < end.
struct RayInterval {
  double begin = std::numeric_limits<double>::infinity(), end = -begin;

  void extend(double t) {
    begin = std::min(begin, t);
    end = std::max(end, t);
  }
  [[nodiscard]] bool is_empty() const { return !(begin < end); }
};

/// q = q0 + kappa (t − middle)² for t in [begin, end).
struct QuadraticPiece {
  double q0, kappa, middle, begin, end;
};

/// A skeleton that has quadratic pieces along a ray, and no ray form.
template <class Shape>
concept HasPieces = requires {
  Shape::kMostPieces;
};

/// The smallest radius.
template <class Shape>
[[nodiscard]] double thinnest(const Shape& shape) {
  if constexpr (requires { shape.thinnest(); }) {
    return shape.thinnest();
  } else {
    return shape.thickest();
  }
}

/// q of a sphere along a ray.
[[nodiscard]] inline QuadraticPiece sphere_piece(const Vec3& centre, double inverse_radius2, const Vec3& origin,
                                                 const Vec3& direction, double begin, double end) {
  // The squared distance from a perpendicular vector, never from |oc|² − (oc·D)², which cancels far from the origin.
  const Vec3 oc = centre - origin;
  const double dd = direction.length2();
  const double middle = oc.dot(direction) / dd;
  return {inverse_radius2 * (oc - direction * middle).length2(), inverse_radius2 * dd, middle, begin, end};
}

/// q = |from + by·t|² over the squared radius: `from` is the offset from the nearest feature at t = 0, and `by` the
/// part of the ray's direction that changes it.
[[nodiscard]] inline QuadraticPiece distance_piece(const Vec3& from, const Vec3& by, double inverse_radius2,
                                                   double begin, double end) {
  const double dd = by.length2();
  const double middle = dd > 0 ? -from.dot(by) / dd : 0;
  return {inverse_radius2 * (from + by * middle).length2(), inverse_radius2 * dd, middle, begin, end};
}

/// The t at which a ray's pieces meet. They are sorted, and each piece is identified by some t inside it.
template <std::size_t N>
class Breaks {
 public:
  /// Adds the t at which the coordinate from + t·by equals `at`, unless there is none or it is farther than any scene
  /// reaches.
  void add(double from, double by, double at) {
    const double t = (at - from) / by;
    if (std::abs(t) < 1e150) t_[count_++] = t;
  }
  /// Calls piece(begin, end, inside) for every stretch; `inside` is a t within it.
  template <class Piece>
  void for_each(const Piece& piece) {
    // Insertion sort of a few values: for std::sort on so short an array, GCC 12 gives a false warning of an overrun.
    for (std::size_t i = 1; i < count_; ++i) {
      for (std::size_t j = i; j > 0 && t_[j] < t_[j - 1]; --j) std::swap(t_[j], t_[j - 1]);
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (count_ == 0) return piece(-kInfinity, kInfinity, 0.0);
    const double first = t_[0], last = t_[count_ - 1];
    const double step = std::max({1.0, std::abs(first), std::abs(last)});
    piece(-kInfinity, first, first - step);
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      if (t_[i] < t_[i + 1]) piece(t_[i], t_[i + 1], t_[i] + 0.5 * (t_[i + 1] - t_[i]));
    }
    piece(last, kInfinity, last + step);
  }

 private:
  std::array<double, N> t_{};
  std::size_t count_ = 0;
};

/// A box relative to an axis (of unit length, through `at`): position x along it in [x_low, x_high], distance ρ from it
/// in [rho_low, rho_high].
struct AxialRange {
  AxialRange(const Box& box, const Vec3& at, const Vec3& axis) {
    const Vec3 half = box.size() * 0.5, centre = box.center() - at;
    const double x = centre.dot(axis), rho = (centre - axis * x).length();
    const double half_x = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
    // A corner's distance from the axis through the centre: its half diagonal without the component along the axis.
    double least_axial2 = half.length2();
    for (const Vec3& diagonal :
         {half, Vec3(-half.x, half.y, half.z), Vec3(half.x, -half.y, half.z), Vec3(half.x, half.y, -half.z)}) {
      const double axial = diagonal.dot(axis);
      least_axial2 = std::min(least_axial2, axial * axial);
    }
    const double half_rho = std::sqrt(std::max(half.length2() - least_axial2, 0.0));
    x_low = x - half_x;
    x_high = x + half_x;
    rho_low = std::max(rho - half_rho, 0.0);
    rho_high = rho + half_rho;
  }

  double x_low, x_high, rho_low, rho_high;
};

/// A box relative to a plane: x = n·(p − a) in [low, high]. The box may be infinite, so components of n that are zero
/// are skipped: their product with infinity would be NaN.
struct PlaneRange {
  PlaneRange(const Box& box, const Vec3& at, const Vec3& normal) : low(-at.dot(normal)), high(low) {
    for (int i = 0; i < 3; ++i) {
      if (normal[i] == 0) continue;
      low += normal[i] * (normal[i] > 0 ? box.min[i] : box.max[i]);
      high += normal[i] * (normal[i] > 0 ? box.max[i] : box.min[i]);
    }
  }

  double low, high;
};

/// Lengths along a plane, from its point nearest to the origin; for `plane { y, d }` they are (x, z).
[[nodiscard]] inline Coordinates plane_coordinates(const Vec3& normal, const Vec3& p) {
  const AcrossAxis across(normal);
  return {p.dot(across.x), p.dot(across.z)};
}

/// A range of q over a box from its value at the centre, for skeletons of one radius: √q changes by no more than the
/// distance over the radius.
[[nodiscard]] inline QRange q_range_by_distance(double q_at_centre, double radius, const Box& box) {
  const double root = std::sqrt(q_at_centre), change = 0.5 * box.size().length() / radius;
  const double low = std::max(root - change, 0.0), high = root + change;
  return {low * low, high * high};
}

}  // namespace isl::render
