// Exact plain solids: where a line crosses each, its normal and its bounds. One file a solid; this is their common
// face.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solids/solid_details.h"

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

/// `direction` may have any length but zero; t is in units of it. `start_part` names the surface that the origin lies
/// on (kNoPart: none): its root at t = 0 is then known, left out, and deflated rather than solved for. `details` are
/// those of the scene that the solid is part of.
[[nodiscard]] Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                  std::uint8_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// For what is made of solids: every change between inside and outside, unseen ones too. Of a sheet (is_sheet), which
/// has no inside, the crossings as above.
[[nodiscard]] Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                 std::uint8_t start_part, const SolidDetails& details = kNoDetails) noexcept;

/// Whether the solid is a surface without an inside: a triangle, a polygon, a box without thickness.
[[nodiscard]] bool is_sheet(const scene::Solid& solid) noexcept;

/// Outward normal of one of the solid's surfaces at a point on it; unit length. At the apex of a cone: its axis. Zero
/// where a polynomial has none (a singular point). Of sheets, the side that POV-Ray's `trace` names.
[[nodiscard]] Vec3 normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                             const SolidDetails& details = kNoDetails) noexcept;

/// The normal to shade with: of a smooth_triangle interpolated between its corners, of all else normal_at().
[[nodiscard]] Vec3 shading_normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                                     const SolidDetails& details = kNoDetails) noexcept;

/// Of the surface. Tight, rounding aside; infinite for planes; of polynomials
/// tight for ellipsoids, a cube for others that are found to end, and infinite else.
[[nodiscard]] Box bounds(const scene::Solid& solid, const SolidDetails& details = kNoDetails) noexcept;

}  // namespace isl::render
