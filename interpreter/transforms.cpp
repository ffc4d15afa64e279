#include "interpreter/transforms.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {

using scene::Matrix;
using scene::Transform;
using scene::Vec3;

namespace {

struct SineCosine {
  double sine, cosine;
};

/// Exact at multiples of 90°, so that quarter turns keep zeros and ones.
SineCosine sine_cosine(double degrees) {
  const double quarter = degrees / 90;
  if (quarter == std::trunc(quarter) && std::abs(quarter) < 1e9) {
    static constexpr double kSines[] = {0, 1, 0, -1};
    const int turn = static_cast<int>(std::fmod(std::fmod(quarter, 4) + 4, 4));
    return {kSines[turn], kSines[(turn + 1) % 4]};
  }
  const double radians = radians_from_degrees(degrees);
  return {std::sin(radians), std::cos(radians)};
}

Matrix linear(double a, double b, double c, double d, double e, double f, double g, double h, double i) {
  return Matrix(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1);
}

}  // namespace

Transform translation(const Vec3& offset) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    t.matrix[3][i] = offset[i];
    t.inverse[3][i] = -offset[i];
  }
  return t;
}

Transform scaling(const Vec3& factors) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    t.matrix[i][i] = factors[i];
    t.inverse[i][i] = 1 / factors[i];
  }
  return t;
}

Transform rotation(const Vec3& degrees) {
  const auto [sx, cx] = sine_cosine(degrees.x);
  const auto [sy, cy] = sine_cosine(degrees.y);
  const auto [sz, cz] = sine_cosine(degrees.z);
  const Matrix x = linear(1, 0, 0, 0, cx, sx, 0, -sx, cx);
  const Matrix y = linear(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
  const Matrix z = linear(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
  const Matrix all = x * y * z;
  return {all, all.transposed()};
}

Vec3 rotated(const Vec3& v, const Vec3& degrees) {
  Vec3 p = v;
  if (degrees.x != 0) {
    const auto [s, c] = sine_cosine(degrees.x);
    p = {p.x, p.y * c - p.z * s, p.y * s + p.z * c};
  }
  if (degrees.y != 0) {
    const auto [s, c] = sine_cosine(degrees.y);
    p = {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
  }
  if (degrees.z != 0) {
    const auto [s, c] = sine_cosine(degrees.z);
    p = {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
  }
  return p;
}

bool invert(const Matrix& m, Matrix& inverse, double& condition) {
  // The rows are the images of the unit vectors; the inverse's columns are their cross products over the determinant.
  const Vec3 x(m[0][0], m[0][1], m[0][2]), y(m[1][0], m[1][1], m[1][2]), z(m[2][0], m[2][1], m[2][2]);
  const Vec3 yz = y.cross(z), zx = z.cross(x), xy = x.cross(y);
  const double determinant = x.dot(yz);
  const double size = std::sqrt(x.dot(x) + y.dot(y) + z.dot(z));
  // A determinant within rounding of zero, relative to the product of the rows' lengths, counts as zero.
  const double scale = std::sqrt(x.dot(x) * y.dot(y) * z.dot(z));
  if (!std::isfinite(determinant) || !(std::abs(determinant) > 1e-15 * scale)) return false;
  inverse = linear(yz.x / determinant, zx.x / determinant, xy.x / determinant, yz.y / determinant, zx.y / determinant,
                   xy.y / determinant, yz.z / determinant, zx.z / determinant, xy.z / determinant);
  const Vec3 offset = -Transform::rotated(Vec3(m[3][0], m[3][1], m[3][2]), inverse);
  for (int i = 0; i < 3; ++i) inverse[3][i] = offset[i];
  condition = size * std::sqrt(yz.dot(yz) + zx.dot(zx) + xy.dot(xy)) / std::abs(determinant);
  return std::isfinite(condition);
}

double condition_of(const Transform& transform) {
  double size = 0, inverse_size = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      size += transform.matrix[i][j] * transform.matrix[i][j];
      inverse_size += transform.inverse[i][j] * transform.inverse[i][j];
    }
  }
  return std::sqrt(size) * std::sqrt(inverse_size);
}

double inverse_error(const Transform& transform) {
  // In extended precision, whose own rounding is three digits below what is measured.
  long double greatest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      long double entry = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) {
        entry += static_cast<long double>(transform.matrix[i][k]) * static_cast<long double>(transform.inverse[k][j]);
      }
      greatest = std::max(greatest, std::abs(entry));
    }
  }
  return static_cast<double>(greatest);
}

double similarity_factor(const Matrix& m) {
  const Vec3 x(m[0][0], m[0][1], m[0][2]), y(m[1][0], m[1][1], m[1][2]), z(m[2][0], m[2][1], m[2][2]);
  const double xx = x.dot(x);
  // Rounding changes the orthogonality of rotations by less than this.
  const double slack = 1e-14 * xx;
  const bool is_similarity = std::abs(y.dot(y) - xx) <= slack && std::abs(z.dot(z) - xx) <= slack &&
                             std::abs(x.dot(y)) <= slack && std::abs(y.dot(z)) <= slack && std::abs(z.dot(x)) <= slack;
  return is_similarity ? std::sqrt(xx) : 0;
}

}  // namespace isl::interpreter
