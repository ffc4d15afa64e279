// Tilings of the plane by polyforms: the edges of a lattice of regular polygons of side 1 that separate two polyforms.
// The lattices, whose columns are the first axis and rows the second:
//
//   4 sides: columns along x, rows along z; a cell owns its right edge and its upper one, as bits 0 and 1;
//   3 sides: a cell is a rhomb of two triangles, columns along x, rows 60 degrees from there; it owns its lower edge,
//            the one that its triangles share, and its left one;
//   6 sides: the middles of columns are 1.5 apart along x, each half a hexagon higher than the one before, rows along
//            z; a cell owns the edges whose normals are at 30, 90 and 150 degrees from x.
#pragma once

#include <string_view>

namespace isl::render {

struct Polyform {
  int sides, tiles;
  int columns, rows, shift;
  std::string_view borders;
};

/// The number of polyforms of `tiles` polygons of `sides` sides; 0 if there is none.
[[nodiscard]] int polyform_count(int sides, int tiles) noexcept;

class PolyformBorders {
 public:
  /// `number` is from 1 to polyform_count(sides, tiles); that count must not be 0.
  PolyformBorders(int sides, int tiles, int number) noexcept;

  /// True if the cell's edge with that bit is a border. Column and row are whole numbers; where they are NaN or beyond
  /// 2³⁰, there are no borders.
  [[nodiscard]] bool operator()(double column, double row, int bit) const noexcept;

 private:
  const Polyform& polyform_;
};

}  // namespace isl::render
