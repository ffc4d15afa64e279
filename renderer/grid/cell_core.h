// The core of a cell: the part that holds all there is in it, as a box. A list is complete for the whole cell, and rays
// are followed in its core alone.
#pragma once

#include "renderer/scene/transform.h"

#include <ImathBox.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace isl::render {

struct CellCore {
  static constexpr int kParts = 256;

  // Distances of the core's sides from those of the cell, in 1/256 of the cell's size. Together they are at most 255 on
  // each axis.
  std::array<std::uint8_t, 3> from_low{}, from_high{};

  bool operator==(const CellCore&) const = default;

  /// The least core of a cell, with its corner `low` and this size, that contains all that is nearer to the box than
  /// `margin` on each axis.
  [[nodiscard]] static CellCore around(const Imath::Box3d& box, const scene::Vec3& low, double size, double margin) {
    CellCore core;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      core.from_low[i] = parts((box.min[axis] - margin - low[axis]) / size, 0);
      core.from_high[i] = parts((low[axis] + size - (box.max[axis] + margin)) / size, core.from_low[i]);
    }
    return core;
  }

  /// True if the core is so much smaller than the cell that it pays to look where a ray meets it.
  [[nodiscard]] bool is_worth_a_look() const {
    bool is_worth = false;
    for (std::size_t axis = 0; axis < 3; ++axis) is_worth |= from_low[axis] + from_high[axis] >= kParts / 4;
    return is_worth;
  }

 private:
  /// A share of the cell in whole parts, rounded down; no more than what another side leaves.
  [[nodiscard]] static std::uint8_t parts(double share, int taken) {
    const double most = kParts - 1 - taken, whole = std::floor(share * kParts);
    return static_cast<std::uint8_t>(!(whole > 0) ? 0 : whole < most ? whole : most);
  }
};

/// (i − 1)/256, for core_planes().
inline constexpr auto kCoreShares = [] {
  std::array<double, 4 * CellCore::kParts + 3> shares{};
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = (static_cast<double>(i) - 1) / CellCore::kParts;
  return shares;
}();

/// The two planes of a core across an axis, in units of the cell's size from its brick's corner; `slab` is the cell's
/// place in the brick. Each lies one part farther out than the core does. Where nothing is cut off, it therefore lies
/// outside the cell, and by more than rounding (kLeastTrimmed): a stretch in the core begins where that in the cell
/// does, and joins the one before it without a gap.
struct CorePlanes {
  double low, high;
};
[[nodiscard]] inline CorePlanes core_planes(const CellCore& core, std::size_t axis, std::uint32_t slab) {
  const std::uint32_t begin = slab * CellCore::kParts;
  return {kCoreShares[begin + core.from_low[axis]], kCoreShares[begin + CellCore::kParts + 2 - core.from_high[axis]]};
}

/// Smaller cells, in units of Grid::rounding, are not trimmed: a part of them is less than four units.
inline constexpr double kLeastTrimmed = 1024;

}  // namespace isl::render
