// Affine maps between spaces, by Imath: row vectors, so `point * first * second` reads in the order of application,
// which is the order in which a scene writes its modifiers. Space: left-handed, y up (POV-Ray's).
#pragma once

#include <ImathMatrix.h>
#include <ImathVec.h>

#include <algorithm>
#include <cmath>

namespace isl::scene {

using Vec3 = Imath::V3d;
using Matrix = Imath::M44d;

/// A map and its inverse. Named destination_from_source where it is used.
struct Transform {
  Matrix matrix;   ///< identity by default
  Matrix inverse;  ///< stored, so that no code computes it again

  [[nodiscard]] Vec3 point(const Vec3& p) const { return transformed(p, matrix); }
  [[nodiscard]] Vec3 vector(const Vec3& v) const { return rotated(v, matrix); }
  [[nodiscard]] Vec3 inverse_point(const Vec3& p) const { return transformed(p, inverse); }
  [[nodiscard]] Vec3 inverse_vector(const Vec3& v) const { return rotated(v, inverse); }
  /// The greatest of the sums of the sizes of the terms that the coordinates of inverse_point(p) are sums of.
  [[nodiscard]] double inverse_terms(const Vec3& p) const {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      double sum = std::abs(inverse[3][i]);
      for (int j = 0; j < 3; ++j) sum += std::abs(p[j] * inverse[j][i]);
      most = std::max(most, sum);
    }
    return most;
  }
  /// Transforms a gradient or normal from source to destination by the inverse transpose; the result is not normalised.
  [[nodiscard]] Vec3 normal(const Vec3& n) const {
    return {inverse[0][0] * n.x + inverse[0][1] * n.y + inverse[0][2] * n.z,
            inverse[1][0] * n.x + inverse[1][1] * n.y + inverse[1][2] * n.z,
            inverse[2][0] * n.x + inverse[2][1] * n.y + inverse[2][2] * n.z};
  }
  /// The opposite of normal(): from destination to source.
  [[nodiscard]] Vec3 inverse_normal(const Vec3& n) const {
    return {matrix[0][0] * n.x + matrix[0][1] * n.y + matrix[0][2] * n.z,
            matrix[1][0] * n.x + matrix[1][1] * n.y + matrix[1][2] * n.z,
            matrix[2][0] * n.x + matrix[2][1] * n.y + matrix[2][2] * n.z};
  }
  [[nodiscard]] Transform inverted() const { return {inverse, matrix}; }
  friend bool operator==(const Transform&, const Transform&) = default;

  /// p·M for an affine M: without the division by w and its rounding.
  [[nodiscard]] static Vec3 transformed(const Vec3& p, const Matrix& m) {
    return rotated(p, m) + Vec3(m[3][0], m[3][1], m[3][2]);
  }
  [[nodiscard]] static Vec3 rotated(const Vec3& v, const Matrix& m) {
    return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
            v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
  }
};

/// First `first`, then `second`.
[[nodiscard]] inline Transform then(const Transform& first, const Transform& second) {
  return {first.matrix * second.matrix, second.inverse * first.inverse};
}

}  // namespace isl::scene
