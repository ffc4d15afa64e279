// Patterns of random cells: `cells`, and Worley's cellular texture ("A Cellular Texture Basis Function", SIGGRAPH 1996)
// as `crackle`.
#pragma once

#include "renderer/scene/pattern.h"
#include "renderer/values/noise.h"

namespace isl::render {

using scene::Vec3;

/// A random number for every unit cube.
[[nodiscard]] double cells(const Vec3& p) noexcept;
/// One random feature point in every unit cube; form · (distances to the nearest three), which `offset` keeps apart,
/// cut to [0, 1]; or the noise at the nearest.
[[nodiscard]] double crackle(const Vec3& p, const scene::CrackleOperands& operands,
                             values::NoiseGenerator generator) noexcept;

}  // namespace isl::render
