// (u, v) of a sphere, a torus and a box, as POV-Ray 3.7 has them (tests/cli/program/povray_pictures_test.cpp compares);
// solids and the skeletons of the same names share them. The skeletons that POV-Ray does not have use the angle about
// an axis (AcrossAxis). All are in the shape's own space.
#pragma once

#include "renderer/scene/transform.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace isl::render {

using scene::Vec3;

struct Coordinates {
  double u = 0, v = 0;

  /// The point at which patterns are evaluated.
  [[nodiscard]] Vec3 point() const { return {u, v, 0}; }
};

/// The angle from x towards z about y, as a share of the full circle, from 0 to 1. It is 0 on the axis.
[[nodiscard]] inline double share_of_turn(double x, double z) {
  if (x == 0 && z == 0) return 0;  // whatever the signs of the zeros
  const double share = std::atan2(z, x) / (2 * std::numbers::pi);
  return share < 0 ? share + 1 : share;
}

/// Coordinates as on a globe: u goes round the y axis from the x axis towards the z axis, v from the south pole to the
/// north pole.
[[nodiscard]] inline Coordinates sphere_coordinates(const Vec3& from_centre) {
  const double across = std::sqrt(from_centre.x * from_centre.x + from_centre.z * from_centre.z);
  return {share_of_turn(from_centre.x, from_centre.z), 0.5 + std::atan2(from_centre.y, across) / std::numbers::pi};
}

/// The torus is about the y axis. u goes round the circle, starting at the −x axis, in the opposite sense to a
/// sphere's; v goes round the tube, from its inside over the bottom.
[[nodiscard]] inline Coordinates torus_coordinates(const Vec3& from_centre, double ring_radius) {
  constexpr double kFull = 2 * std::numbers::pi;
  const double across = std::sqrt(from_centre.x * from_centre.x + from_centre.z * from_centre.z) - ring_radius;
  return {0.5 - std::atan2(from_centre.z, from_centre.x) / kFull, 0.5 + std::atan2(from_centre.y, across) / kFull};
}

/// The box unfolded into a cross, four faces wide and three high: in the middle row, from the left, the faces at low x,
/// high z, high x and low z; the one at high y above that at high z, the one at low y below. A point is on the face
/// whose plane it is farthest beyond.
[[nodiscard]] inline Coordinates box_coordinates(const Vec3& low, const Vec3& high, const Vec3& p) {
  int axis = 0;
  bool is_high = false;
  double beyond = -std::numeric_limits<double>::infinity();
  Vec3 share;  // of the way from low to high
  for (int i = 0; i < 3; ++i) {
    if (low[i] - p[i] > beyond) axis = i, is_high = false, beyond = low[i] - p[i];
    if (p[i] - high[i] > beyond) axis = i, is_high = true, beyond = p[i] - high[i];
    share[i] = p[i] <= low[i] ? 0 : p[i] >= high[i] ? 1 : (p[i] - low[i]) / (high[i] - low[i]);
  }
  const double middle_row = (1 + share.y) / 3;
  if (axis == 0) return {is_high ? (3 - share.z) / 4 : share.z / 4, middle_row};
  if (axis == 1) return {(1 + share.x) / 4, is_high ? 1 - share.z / 3 : share.z / 3};
  return {is_high ? (1 + share.x) / 4 : 1 - share.x / 4, middle_row};
}

/// The directions perpendicular to an axis from which angles about it are measured: the images of x and z under the
/// smallest rotation that takes y to the axis (about x if the axis is −y).
struct AcrossAxis {
  Vec3 x, z;

  /// `axis` has unit length. With s = axis.y + 1 a vector p becomes p − (p·axis + p.y)/s · (axis + y) + 2 p.y · axis.
  explicit AcrossAxis(const Vec3& axis) {
    const double square = axis.x * axis.x + axis.z * axis.z;
    // Half of the sphere needs the other form of 1/s = (1 − y)/(1 − y²), whose numerators vanish with its denominator.
    const double xx = axis.y >= 0 ? axis.x * axis.x / (1 + axis.y) : scaled(axis.x * axis.x, axis.y, square);
    const double xz = axis.y >= 0 ? axis.x * axis.z / (1 + axis.y) : scaled(axis.x * axis.z, axis.y, square);
    const double zz = axis.y >= 0  ? axis.z * axis.z / (1 + axis.y)
                      : square > 0 ? scaled(axis.z * axis.z, axis.y, square)
                                   : 2;
    x = {1 - xx, -axis.x, -xz};
    z = {-xz, -axis.z, 1 - zz};
  }

  /// The angle of `p` about the axis, as a share of the full circle.
  [[nodiscard]] double share_of_turn(const Vec3& p) const { return render::share_of_turn(p.dot(x), p.dot(z)); }

 private:
  [[nodiscard]] static double scaled(double product, double y, double square) {
    return square > 0 ? product / square * (1 - y) : 0;
  }
};

}  // namespace isl::render
