// The ray form: the interface to the inner loops of a skeleton whose q is not a quadratic along a ray. It is a struct
// of octets, whose lanes are eight fields along one ray or one field along eight rays; its user chooses. Its members
// are, in this order, kAlong octets that depend on field and ray, kShape octets that depend on the field alone, and
// `amplitude`. Its functions are
//
//   along<N>(shape, lines)          the kAlong members, for one line (N = double) or for eight (Octet)
//   shape(shape)                    the kShape members
//   kOutOfReach                     values of all these for unused lanes: no support reaches the ray
//   at(t, scale)                    v = scale · q, dv/dt and v/distance²
//   second(t, scale)                d²v/dt²
//   bounds(t0, t1, scale, support)  ShapeBounds of v on a stretch, which need not hold beyond the support
//
// and RayFormOf<Shape> is specialised for it.
#if defined(ISL_RENDERER_FIELDS_SKELETONS_RAY_FORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_SKELETONS_RAY_FORM_INL_H_
#undef ISL_RENDERER_FIELDS_SKELETONS_RAY_FORM_INL_H_
#else
#define ISL_RENDERER_FIELDS_SKELETONS_RAY_FORM_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/scene/transform.h"
#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// v = scale · q = factor · distance², and dv/dt.
struct LanePoint {
  Octet v, slope, factor;
};

/// Bounds of v on a stretch of a ray, for skeletons that do not treat pieces of v separately.
struct ShapeBounds {
  JetBounds v;
  OctetMask one_piece;  ///< v is certainly smooth on the stretch
  Octet least, greatest;
  Octet factor;  ///< the greatest quotient v/distance² on the stretch

  /// Bounds of f″ and f⁗ for the field f of this kernel.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE SecondAndFourth compose(const Kernel& kernel) const {
    return render::HWY_NAMESPACE::compose(kernel, v);
  }
  /// Upper bound of |f′|.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet steepest(const Kernel& kernel) const {
    return kernel.slopes(v.least).first * v.first;
  }
};

/// A distance beyond any support whose square is finite.
inline constexpr double kFarAway = 1e100;

/// The ray form of a skeleton; void if it has none.
template <class Shape>
struct RayFormOf {
  using type = void;
};

/// The quadratic of a QuadraticPiece along each of eight rays.
struct OctetQuadratic {
  Octet q0, kappa, middle;
};

/// The class whose along(shape, lines, emit) finds the pieces of a skeleton along eight rays; void if they are found
/// ray by ray. It calls emit(begin, end, quadratic) for each piece, which is empty where begin ≥ end; quadratic() gives
/// the OctetQuadratic, if it is asked for.
template <class Shape>
struct PiecesAlong {
  using type = void;
};

/// Lines o + d t, in a component's own space.
template <class N>
struct Lines {
  N o[3], d[3];
};

/// A line relative to an axis: the position along the axis is x₀ + x′t, the squared distance from it
/// n₀ + n₂(t − middle)².
template <class N>
struct AboutAxis {
  N x0, dx, n0, n2, middle;
};

/// The lines relative to the axis through `at`; `axis` has unit length.
template <class N>
[[nodiscard]] HWY_INLINE AboutAxis<N> about_axis(const scene::Vec3& at, const scene::Vec3& axis,
                                                 const Lines<N>& lines) {
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

/// That of sphere_piece() for one ray.
[[nodiscard]] HWY_INLINE OctetQuadratic sphere_quadratic(const scene::Vec3& centre, const Octet& inverse_radius2,
                                                         const Lines<Octet>& lines) {
  const Octet x = Octet(centre.x) - lines.o[0], y = Octet(centre.y) - lines.o[1], z = Octet(centre.z) - lines.o[2];
  const auto& d = lines.d;
  const Octet dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const Octet middle = (x * d[0] + y * d[1] + z * d[2]) / dd;
  const Octet px = x - middle * d[0], py = y - middle * d[1], pz = z - middle * d[2];
  return {inverse_radius2 * (px * px + py * py + pz * pz), inverse_radius2 * dd, middle};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
