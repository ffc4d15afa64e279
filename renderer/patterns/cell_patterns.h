// Patterns of random cells: `cells`, and Worley's cellular texture ("A Cellular Texture Basis Function", SIGGRAPH 1996)
// as `crackle`. Random numbers come from std::mt19937 with its default seed, found by a hash of the unit cube.
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

using scene::Vec3;

/// A random number for every unit cube.
[[nodiscard]] double cells(const Vec3& p) noexcept;
/// One random feature point in every unit cube; form · (distances to the nearest three) + offset, or a random number of
/// the nearest.
[[nodiscard]] double crackle(const Vec3& p, const scene::CrackleOperands& operands) noexcept;

}  // namespace isl::render
