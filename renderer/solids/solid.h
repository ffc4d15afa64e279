// The interface to all solids: crossings with a line, normals, bounds and extent, inside. Each kind has one file
// (solid_type.h documents its content).
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solids/solid_details.h"
#include "renderer/solids/surface_coordinates.h"

#include <ImathBox.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace isl::render {

using scene::Vec3;
using Box = Imath::Box3d;

/// The part of a start that is on no surface.
inline constexpr std::uint32_t kNoPart = 0xFFFFFFFF;
/// The part of a crossing between inside and outside without a surface: at the missing caps of an open tube, or in the
/// plane of a disc beyond its rim. Only boundary() reports such crossings.
inline constexpr std::uint32_t kUnseen = 0xFFFFFFFE;

/// A list whose first elements need no memory of their own, and are not touched before they are set: most solids have
/// two crossings, but text has any number.
template <class T>
class CrossingList {
 public:
  T& operator[](std::size_t i) { return i < kNear ? near_[i] : far_[i - kNear]; }
  const T& operator[](std::size_t i) const { return i < kNear ? near_[i] : far_[i - kNear]; }
  void set(std::size_t i, const T& value) {
    if (i >= kNear) far_.resize(i - kNear + 1);
    (*this)[i] = value;
  }
  /// Moves the first `count` elements here.
  void take(CrossingList& other, std::size_t count) {
    std::copy_n(other.near_.begin(), std::min(count, kNear), near_.begin());
    far_ = std::move(other.far_);
  }

 private:
  /// POV-Ray's `poly` allows polynomials up to order 35, which have at most 35 roots.
  static constexpr std::size_t kNear = 36;
  std::array<T, kNear> near_;
  std::vector<T> far_;
};

/// The crossings of a line with a solid's surface, t ascending. All crossings with t > 0 are included; those behind the
/// origin may be left out. A tangency is no crossing.
struct Crossings {
  Crossings() = default;
  Crossings(Crossings&& other) noexcept : count(other.count), ends_inside(other.ends_inside) {
    t.take(other.t, static_cast<std::size_t>(count));
    part.take(other.part, static_cast<std::size_t>(count));
  }

  int count = 0;
  bool ends_inside = false;  ///< the line is inside beyond the last crossing; false for bounded solids
  CrossingList<double> t;    ///< the first `count` are set
  CrossingList<std::uint32_t> part;

  void add(double at, std::uint32_t surface) {
    t.set(static_cast<std::size_t>(count), at);
    part.set(static_cast<std::size_t>(count), surface);
    ++count;
  }
};

// ---- For rays -------------------------------------------------------------------------------------------------------

/// `direction` may have any length but zero; t is in units of it. `start_part` names the surface that the origin lies
/// on (kNoPart: none): its root at t = 0 is then known, left out, and deflated rather than solved for. `details` are
/// those of the scene that the solid is part of.
[[nodiscard]] Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                  std::uint32_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// As crossings(), but those behind the first one with t > 0 may be left out; `ends_inside` is then meaningless.
[[nodiscard]] Crossings crossings_to_first(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                           std::uint32_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// The part of a line from t = `from` to `to`, 0 ≤ from, and how far crossings in it are wanted.
struct Stretch {
  double from = 0, to = std::numeric_limits<double>::infinity();
  double wanted_to = std::numeric_limits<double>::infinity();  ///< no digit of any crossing depends on it
};

/// For set operations on solids: every change between inside and outside, with kUnseen ones. For an open surface
/// (is_open_surface), which has no inside, the result is that of crossings(). Crossings outside of the stretch, and
/// those from `wanted_to` on, may be left out; `ends_inside` is then the state behind the last one that is not.
[[nodiscard]] Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                 std::uint32_t start_part, const SolidDetails& details = kNoDetails,
                                 const Stretch& stretch = {}) noexcept;

/// True if a stretch saves boundary() time.
[[nodiscard]] bool gains_by_stretch(const scene::Solid& solid) noexcept;

/// True if the solid is a surface without an inside: a triangle, a polygon, a box without thickness.
[[nodiscard]] bool is_open_surface(const scene::Solid& solid) noexcept;

/// True if the surface is part of a plane that continues as an unseen boundary, like a disc's: the inside is the
/// half-space behind the plane, which has a normal beyond the surface too.
[[nodiscard]] bool is_part_of_plane(const scene::Solid& solid) noexcept;

/// Outward normal of one of the solid's surfaces at a point on it; unit length. At the apex of a cone it is the axis;
/// at a singular point of a polynomial it is zero. For open surfaces it points to the side of POV-Ray's `trace`.
[[nodiscard]] Vec3 normal_at(const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                             const SolidDetails& details = kNoDetails) noexcept;

/// The normal for shading: interpolated between the corners of a smooth_triangle, and normal_at() for all other solids.
[[nodiscard]] Vec3 shading_normal_at(const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                                     const SolidDetails& details = kNoDetails) noexcept;

/// (u, v) at a point on the surface, in the solid's space and in the world. POV-Ray defines coordinates for a few
/// solids; for every other one they are (x, y) in the world.
[[nodiscard]] Coordinates solid_coordinates(const scene::Solid& solid, const Vec3& point, const Vec3& world) noexcept;

/// The bounding box of the surface. It is tight up to rounding; infinite for planes. For polynomials it is tight for
/// ellipsoids, a cube for others that are found to be bounded, and otherwise infinite.
[[nodiscard]] Box bounds(const scene::Solid& solid, const SolidDetails& details = kNoDetails) noexcept;

/// The sum of a polynomial's absolute terms at a point of the surface, divided by the length of the gradient: the
/// condition of the surface. A relative error ε of the terms moves the surface by ε times this length. Zero where the
/// gradient is zero, and for all other solids, whose numbers determine the surface up to their rounding.
[[nodiscard]] double terms_over_gradient(const scene::Solid& solid, const Vec3& point,
                                         const SolidDetails& details = kNoDetails) noexcept;

// ---- For questions about the scene, from the database alone ---------------------------------------------------------

/// The support function of convex geometry: the greatest direction · p over the solid, in its own space. It is infinite
/// if the solid is unbounded in that direction, or no bound is known (cubic, quartic, poly); for all others it is exact
/// up to rounding. `direction` may have any length but zero.
[[nodiscard]] double support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction);

/// The bounding box of the transformed solid, tight if `support` is exact; its sides may be infinite.
[[nodiscard]] Box box_of(const scene::Database& database, const scene::Solid& solid,
                         const scene::Transform& world_from_solid);

/// True if a point in the solid's own space is inside. As in POV-Ray, points on the surface are outside for a sphere,
/// cylinder, cone or disc, and inside for all other solids. Triangles and polygons have no inside; that of a disc is
/// the half-space behind it.
[[nodiscard]] bool is_inside(const scene::Database& database, const scene::Solid& solid, const Vec3& point);

/// The largest coordinate among the numbers that describe the solid, in its own space.
[[nodiscard]] double size_of(const scene::Database& database, const scene::Solid& solid);

}  // namespace isl::render
