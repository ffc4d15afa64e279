// The three sets of tiles by Penrose that cover the plane without a period ("Pentaplexity", 1979): pentagons with
// stars, boats and rhombs; kites and darts; and two rhombs. Each covers the plane with fivefold symmetry about the
// origin.
//
// Values are (kind + 1 − min(k d, 1)) / kinds, where d is the distance from the tile's border: kind / kinds in the
// middle of a tile, (kind + 1) / kinds at its border. They were measured in POV-Ray 3.7, whose k is 4.46 for kites and
// 11.1 / (1 + √5) for both others.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

// Tiles are in the plane of x and z and have sides of length 1 (kites and darts: long sides).
/// Kinds: pentagons by their orientation (0, 1, 2), then stars, boats and rhombs.
[[nodiscard]] double penrose_pentagons(const scene::Vec3& p) noexcept;
/// Kinds: kites, then darts.
[[nodiscard]] double penrose_kites(const scene::Vec3& p) noexcept;
/// Kinds: wide rhombs, then narrow ones.
[[nodiscard]] double penrose_rhombs(const scene::Vec3& p) noexcept;

}  // namespace isl::render
