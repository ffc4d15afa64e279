// Eight vectors side by side. Each operation adds and multiplies in the order of Imath's Vec3, so that a formula has
// the same bits for eight rays as for one.
#if defined(ISL_RENDERER_SOLIDS_OCTET_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_VECTOR_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_VECTOR_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_VECTOR_INL_H_
#endif

#include "renderer/scene/transform.h"
#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct OctetVector {
  Octet x, y, z;

  HWY_INLINE OctetVector() = default;
  HWY_INLINE OctetVector(const Octet& x_, const Octet& y_, const Octet& z_) : x(x_), y(y_), z(z_) {}
  /// One vector in all lanes.
  HWY_INLINE OctetVector(const scene::Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: stands for eight of it

  [[nodiscard]] HWY_INLINE Octet dot(const OctetVector& v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] HWY_INLINE OctetVector cross(const OctetVector& v) const {
    return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x};
  }
};

HWY_INLINE OctetVector operator+(const OctetVector& a, const OctetVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE OctetVector operator-(const OctetVector& a, const OctetVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE OctetVector operator*(const OctetVector& v, const Octet& by) { return {v.x * by, v.y * by, v.z * by}; }

/// Eight lines o + d t.
struct OctetLines {
  OctetVector origin, direction;
};

/// As Transform::rotated().
[[nodiscard]] HWY_INLINE OctetVector rotated(const OctetVector& v, const scene::Matrix& m) {
  const auto along = [&](int i) HWY_ATTR { return v.x * Octet(m[0][i]) + v.y * Octet(m[1][i]) + v.z * Octet(m[2][i]); };
  return {along(0), along(1), along(2)};
}

/// The lines in the space that `inverse` leads to.
[[nodiscard]] HWY_INLINE OctetLines mapped(const OctetLines& lines, const scene::Matrix& inverse) {
  const scene::Vec3 offset(inverse[3][0], inverse[3][1], inverse[3][2]);
  return {rotated(lines.origin, inverse) + offset, rotated(lines.direction, inverse)};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
