// Lines about an axis: how cones, circles and convolved curves are met, by one line in numbers or by eight in octets.
#if defined(ISL_RENDERER_FIELDS_RAY_ABOUT_AXIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_ABOUT_AXIS_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_ABOUT_AXIS_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_ABOUT_AXIS_INL_H_
#endif

#include "renderer/scene/transform.h"
#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Lines o + d t, in a component's own space.
template <class N>
struct Lines {
  N o[3], d[3];
};

/// Seen from an axis: the place along it, x₀ + x′t, and the squared distance from it, n₀ + n₂(t − middle)².
template <class N>
struct AboutAxis {
  N x0, dx, n0, n2, middle;
};

/// `axis` has unit length and goes through `at`.
template <class N>
[[nodiscard]] HWY_INLINE AboutAxis<N> about_axis(const scene::Vec3& at, const scene::Vec3& axis, const Lines<N>& lines) {
  const N ax(axis.x), ay(axis.y), az(axis.z);
  N ox = lines.o[0] - N(at.x), oy = lines.o[1] - N(at.y), oz = lines.o[2] - N(at.z);
  N dx = lines.d[0], dy = lines.d[1], dz = lines.d[2];
  AboutAxis<N> r;
  r.x0 = ox * ax + oy * ay + oz * az;
  r.dx = dx * ax + dy * ay + dz * az;
  ox = ox - ax * r.x0, oy = oy - ay * r.x0, oz = oz - az * r.x0;
  dx = dx - ax * r.dx, dy = dy - ay * r.dx, dz = dz - az * r.dx;
  r.n2 = dx * dx + dy * dy + dz * dz;
  r.middle = select(r.n2 > N(0.0), N(0.0) - (ox * dx + oy * dy + oz * dz) / r.n2, N(0.0));
  ox = ox + dx * r.middle, oy = oy + dy * r.middle, oz = oz + dz * r.middle;
  r.n0 = ox * ox + oy * oy + oz * oz;
  return r;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
