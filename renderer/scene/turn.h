// The orthogonal part (rotation or reflection) of a similarity. It is kept when the similarity is baked into a
// component's points and radii: a sphere rotated about its centre is the same sphere, but its north pole, which surface
// coordinates depend on, is elsewhere.
#pragma once

#include "base/growing_array.h"
#include "renderer/scene/transform.h"

#include <ImathMatrix.h>

#include <cmath>

namespace isl::scene {

/// An orthogonal map, reflections included. Row vectors, as in Transform.
struct Turn {
  Imath::M33d matrix;  ///< identity by default

  [[nodiscard]] bool is_none() const { return matrix == Imath::M33d(); }
  /// Applies the inverse to a direction.
  [[nodiscard]] Vec3 back(const Vec3& v) const {
    return {v.x * matrix[0][0] + v.y * matrix[0][1] + v.z * matrix[0][2],
            v.x * matrix[1][0] + v.y * matrix[1][1] + v.z * matrix[1][2],
            v.x * matrix[2][0] + v.y * matrix[2][1] + v.z * matrix[2][2]};
  }
  friend bool operator==(const Turn&, const Turn&) = default;
};

/// The orthogonal part of a similarity; translations and uniform scalings by a positive factor give exactly Turn().
[[nodiscard]] inline Turn turn_of(const Matrix& similarity) {
  const Matrix& m = similarity;
  const double factor = std::sqrt(m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[0][2] * m[0][2]);
  return {Imath::M33d(m[0][0] / factor, m[0][1] / factor, m[0][2] / factor, m[1][0] / factor, m[1][1] / factor,
                      m[1][2] / factor, m[2][0] / factor, m[2][1] / factor, m[2][2] / factor)};
}

/// First `first`, then `second`.
[[nodiscard]] inline Turn then(const Turn& first, const Turn& second) { return {first.matrix * second.matrix}; }

}  // namespace isl::scene

template <>
inline constexpr bool isl::kMovesAsBytes<isl::scene::Turn> = true;
