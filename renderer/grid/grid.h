// The sparse nested grid tells where on a ray there is anything to solve. A brick has 4×4×4 cubic cells, any of which
// may be a brick of smaller ones, to any depth, so that empty space costs one step and detail costs what it needs.
// Every cell is classified when the grid is built (grid/field_classifier.h), and its list is complete, so that each
// cell is solved by itself. After Klimaszewski and Sederberg 1997 (nested grids), walked as in Amanatides and Woo 1987.
#pragma once

#include "renderer/grid/cell_core.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <ImathBox.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace isl::render {

using scene::Vec3;
using Box = Imath::Box3d;

enum class CellKind : std::uint32_t {
  empty,   ///< nothing here, or a field certainly below the threshold
  inside,  ///< a field certainly above the threshold
  leaf,    ///< `first` and `count`: the items that matter here
  brick,   ///< `first`: the first of 64 cells
  choice,  ///< `first` and `count`: lists in Grid::choices, the field being the greatest of theirs
};

struct Cell {
  std::uint32_t first = 0;
  std::uint32_t kind_and_count = 0;
  CellCore core;            ///< of a leaf, choice or brick: a field is below the threshold outside it
  bool is_trimmed = false;  ///< rays are followed in the core alone

  bool operator==(const Cell&) const = default;
  [[nodiscard]] CellKind kind() const { return static_cast<CellKind>(kind_and_count & 7); }
  [[nodiscard]] std::uint32_t count() const { return kind_and_count >> 3; }
  /// `size` of the cell and `rounding` as Grid::rounding.
  void set_core(const CellCore& to, double size, double rounding) {
    core = to;
    is_trimmed = to.is_worth_a_look() && size >= kLeastTrimmed * rounding;
  }
  [[nodiscard]] static Cell make(CellKind kind, std::uint32_t first = 0, std::uint32_t count = 0) {
    return {first, static_cast<std::uint32_t>(kind) | count << 3, {}, false};
  }
};
static_assert(sizeof(Cell) == 16);

inline constexpr int kBrickSide = 4;
inline constexpr std::uint32_t kBrickCells = 64;

/// Levels below the top one. They divide the cells of the top by 4¹⁶ = 2³², which is more than separates the largest
/// scene from its smallest part if a double is to have bits to spare.
inline constexpr int kMaxGridDepth = 16;

/// The largest coordinate of a box that a grid is laid out in. The layout of cells computes sizes, centres and margins,
/// which are sums of at most eight such coordinates and must not overflow.
inline constexpr double kFarthestInGrid = std::numeric_limits<double>::max() / 16;

/// items[first … first + count − 1] of a grid.
struct ItemList {
  std::uint32_t first, count;
};

struct Grid {
  static constexpr std::size_t kListTail = 7;

  Box bounds;                           ///< bounds of the content; empty if there is none
  Box box;                              ///< bounds of the top brick's cells in use
  Box core;                             ///< the part of `box` in which rays are followed
  double cell_size = 0;                 ///< side of the top brick's cells, the same on every axis
  double rounding = 0;                  ///< no plane between cells is off by more where a ray in the box meets it
  int dimensions[3] = {0, 0, 0};        ///< number of cells in use, 1 to 4 an axis; the others are empty
  std::vector<Cell> cells;              ///< bricks of 64, x fastest; the first is the top
  std::vector<std::uint64_t> occupied;  ///< one bit for each cell of a brick, set if the cell is not empty
  std::vector<std::uint32_t> items;     ///< the lists of leaves, then kListTail zeros, because lists are read eight
                                        ///< entries at a time
  std::vector<ItemList> choices;
  std::uint32_t longest_list = 0;

  /// Items without end, and the cell for all that lies beyond the box; kNone if only empty space does.
  std::vector<std::uint32_t> endless_items;
  std::uint32_t beyond = scene::kNone;

  /// The lists of a leaf (one) or choice.
  [[nodiscard]] std::uint32_t list_count(const Cell& cell) const {
    return cell.kind() == CellKind::choice ? cell.count() : cell.kind() == CellKind::leaf ? 1 : 0;
  }
  [[nodiscard]] ItemList list(const Cell& cell, std::uint32_t i) const {
    return cell.kind() == CellKind::choice ? choices[cell.first + i] : ItemList{cell.first, cell.count()};
  }

  [[nodiscard]] bool is_empty() const { return cells.empty(); }
  [[nodiscard]] std::size_t list_entries() const { return is_empty() ? 0 : items.size() - kListTail; }
  /// Gives back the memory that nothing will be added to.
  void shrink_to_fit() {
    cells.shrink_to_fit();
    items.shrink_to_fit();
    choices.shrink_to_fit();
  }
  [[nodiscard]] std::size_t bytes() const {
    return cells.capacity() * sizeof(Cell) + occupied.capacity() * sizeof(std::uint64_t) +
           (items.capacity() + endless_items.capacity()) * sizeof(std::uint32_t) +
           choices.capacity() * sizeof(ItemList);
  }
};

}  // namespace isl::render
