// Exact plain solids: where a line crosses each, its normal, its bounds and extent, its inside. One file a kind
// (solid_type.h says what is in it); this is their common face.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solids/solid_details.h"
#include "renderer/solids/surface_coordinates.h"

#include <ImathBox.h>

#include <array>
#include <cstdint>

namespace isl::render {

using scene::Vec3;
using Box = Imath::Box3d;

/// A start that is on no surface.
inline constexpr std::uint8_t kNoPart = 0xFF;
/// Where a line passes between the inside and the outside of a solid without meeting a surface: the missing caps of an
/// open tube, the plane of a disc beyond its rim. Only boundary() tells of it.
inline constexpr std::uint8_t kUnseen = 0xFE;

/// The crossings of a line with a solid's surface, t ascending. All with t > 0 are there; those behind the origin may
/// be left out. Tangency is no crossing.
struct Crossings {
  /// A polynomial of order 35 has no more roots; POV-Ray's `poly` goes so far.
  static constexpr int kMost = 36;

  int count = 0;
  bool ends_inside = false;     ///< whether the line is inside beyond the last crossing; false for whatever is bounded
  std::array<double, kMost> t;  ///< the first `count` are set; the rest is not touched, since most solids have two
  std::array<std::uint8_t, kMost> part;

  void add(double at, std::uint8_t surface) {
    if (count == kMost) return;
    t[static_cast<std::size_t>(count)] = at;
    part[static_cast<std::size_t>(count)] = surface;
    ++count;
  }
};

// ---- For rays -------------------------------------------------------------------------------------------------------

/// `direction` may have any length but zero; t is in units of it. `start_part` names the surface that the origin lies
/// on (kNoPart: none): its root at t = 0 is then known, left out, and deflated rather than solved for. `details` are
/// those of the scene that the solid is part of.
[[nodiscard]] Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                  std::uint8_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// For what is made of solids: every change between inside and outside, unseen ones too. Of an open surface
/// (is_open_surface), which has no inside, the crossings as above.
[[nodiscard]] Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                 std::uint8_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// Whether the solid is a surface without an inside: a triangle, a polygon, a box without thickness.
[[nodiscard]] bool is_open_surface(const scene::Solid& solid) noexcept;

/// Whether the surface is a part of a plane that goes on unseen, as a disc's is: its inside is all that lies behind
/// that plane, and the plane has a normal beyond the surface too.
[[nodiscard]] bool is_part_of_plane(const scene::Solid& solid) noexcept;

/// Outward normal of one of the solid's surfaces at a point on it; unit length. At the apex of a cone: its axis. Zero
/// where a polynomial has none (a singular point). Of open surfaces, the side that POV-Ray's `trace` names.
[[nodiscard]] Vec3 normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                             const SolidDetails& details = kNoDetails) noexcept;

/// The normal to shade with: of a smooth_triangle interpolated between its corners, of all else normal_at().
[[nodiscard]] Vec3 shading_normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                                     const SolidDetails& details = kNoDetails) noexcept;

/// (u, v) at a point on the surface, in the solid's space and in the world. POV-Ray has coordinates of a few solids; of
/// every other one they are (x, y) in the world.
[[nodiscard]] Coordinates solid_coordinates(const scene::Solid& solid, const Vec3& point, const Vec3& world) noexcept;

/// Of the surface. Tight, rounding aside; infinite for planes; of polynomials
/// tight for ellipsoids, a cube for others that are found to end, and infinite else.
[[nodiscard]] Box bounds(const scene::Solid& solid, const SolidDetails& details = kNoDetails) noexcept;

/// How well the terms of a polynomial determine its surface: the sum of the absolute terms at a point of the surface
/// over the length of the gradient. A rounding of the terms by a share moves the surface by this share of that length.
/// Zero where the gradient is, and for all other solids, whose numbers determine it to their rounding.
[[nodiscard]] double terms_over_gradient(const scene::Solid& solid, const Vec3& point,
                                         const SolidDetails& details = kNoDetails) noexcept;

// ---- For questions about the scene, from the database alone ---------------------------------------------------------

/// How far the solid reaches in a direction, the support function of convex geometry: the greatest direction · p over
/// the solid, in its own space; infinite where it has no end that way, and where none is known (cubic, quartic, poly).
/// Exact for all others, rounding aside. `direction` may have any length but zero.
[[nodiscard]] double support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction);

/// The box of the solid after a map, tight where `support` is exact; its sides may be infinite.
[[nodiscard]] Box box_of(const scene::Database& database, const scene::Solid& solid,
                         const scene::Transform& world_from_solid);

/// Whether a point lies inside, in the solid's own space. Of the surface itself, as in POV-Ray: it is outside a sphere,
/// cylinder, cone or disc and inside everything else. Triangles and polygons have no inside; that of a disc is the
/// half-space behind it.
[[nodiscard]] bool is_inside(const scene::Database& database, const scene::Solid& solid, const Vec3& point);

/// The largest coordinate among the numbers that describe the solid, in its own space.
[[nodiscard]] double size_of(const scene::Database& database, const scene::Solid& solid);

}  // namespace isl::render
