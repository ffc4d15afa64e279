// A map of an outline's plane: which cells of a grid over the outline's box no curve comes near. Most lines that a
// sweep is asked for pass over so little of the plane that it tells all about them.
#pragma once

#include "renderer/scene/solids.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::render {

struct OutlineMap {
  enum class Side : std::uint8_t { mixed, outside, inside };

  std::vector<Side> sides;     ///< by row, then column; empty if nothing is known
  int columns = 0, rows = 0;   ///< along u and v
  scene::PlanePoint low;       ///< of the box
  scene::PlanePoint per_unit;  ///< columns and rows per unit

  [[nodiscard]] int column(double u) const { return number((u - low.u) * per_unit.u, columns); }
  [[nodiscard]] int row(double v) const { return number((v - low.v) * per_unit.v, rows); }
  [[nodiscard]] Side& at(int column, int row) { return sides[index(column, row)]; }

  /// The side of all points of a rectangle; mixed if they differ or if it is not known. Rounding is monotone, so that
  /// no cell is left out.
  [[nodiscard]] Side side_of(const scene::PlanePoint& from, const scene::PlanePoint& to) const {
    if (sides.empty() || !(from.u <= to.u && from.v <= to.v)) return Side::mixed;
    const int u0 = column(from.u), u1 = column(to.u), v0 = row(from.v), v1 = row(to.v);
    if (u1 < 0 || v1 < 0 || u0 == columns || v0 == rows) return Side::outside;
    constexpr int kMost = 6;  // along each side: a rectangle of more cells is hardly ever on one side
    if (u1 - u0 >= kMost || v1 - v0 >= kMost) return Side::mixed;
    const Side side = side_at(u0, v0);
    for (int v = v0; v <= v1; ++v) {
      for (int u = u0; u <= u1; ++u) {
        if (side_at(u, v) != side) return Side::mixed;
      }
    }
    return side;
  }

 private:
  /// -1 below the box and `count` beyond it.
  [[nodiscard]] static int number(double place, int count) {
    return place >= count ? count : place >= 0 ? static_cast<int>(place) : -1;
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] Side side_at(int column, int row) const {
    if (column < 0 || row < 0 || column == columns || row == rows) return Side::outside;
    return sides[index(column, row)];
  }
};

struct PreparedOutline;

/// Makes the map of an outline. Precondition: the outline's nodes are made.
[[nodiscard]] OutlineMap map_of(const PreparedOutline& outline);

}  // namespace isl::render
