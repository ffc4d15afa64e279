// Builds a Grid from the top down. What a cell is, and whether dividing it pays, is the classifier's to say:
//
//   Cell kind   classify(box, items, kept)   what the cell is, given the items of its parent; fills `kept` if it is a leaf
//   bool        should_divide(size, kept)    whether a leaf is worth dividing, size = its side
//   Box         item_bounds(item)            a box around all that the item touches
//
// A box is handed over enlarged by 2⁻²⁰ of its size on every side, so that the rounding of a ray's position (a few units in
// the last place of the grid's extent) never decides which items a point sees.
#pragma once

#include "renderer/grid/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace isl::render {

template <class Classifier>
class GridBuilder {
 public:
  explicit GridBuilder(Classifier& classifier) : classifier_(classifier) {}

  /// `bounds` holds everything; `items` are all item numbers.
  [[nodiscard]] Grid build(const Box& bounds, std::span<const std::uint32_t> items) {
    grid_ = {};
    if (bounds.isEmpty() || items.empty()) return std::move(grid_);
    lay_out_top_brick(bounds);
    const std::vector<std::vector<std::uint32_t>> lists = deal_out(items);
    for (std::uint32_t index = 0; index < kBrickCells; ++index) {
      if (!lists[index].empty()) build_cell(index, grid_.box.min + corner(index) * grid_.cell_size, grid_.cell_size, lists[index], 0);
    }
    mark_occupied();
    grid_.cells.shrink_to_fit();
    grid_.items.shrink_to_fit();
    return std::move(grid_);
  }

 private:
  /// Cubic cells, four on the longest side of the content, about its centre; wider by 2⁻²⁰, as every cell is.
  void lay_out_top_brick(const Box& bounds) {
    const Vec3 size = bounds.size();
    const double longest = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
    grid_.bounds = bounds;
    grid_.cell_size = longest * (1 + 0x1p-20) / kBrickSide;
    Vec3 half;
    for (int axis = 0; axis < 3; ++axis) {
      grid_.dimensions[axis] = std::clamp(static_cast<int>(std::ceil(size[axis] / grid_.cell_size)), 1, kBrickSide);
      half[axis] = 0.5 * grid_.cell_size * grid_.dimensions[axis];
    }
    grid_.box = Box(bounds.center() - half, bounds.center() + half);
    grid_.cells.resize(kBrickCells);
  }

  [[nodiscard]] static Vec3 corner(std::uint32_t index) { return Vec3(index % 4, index / 4 % 4, index / 16); }

  /// Which items may touch which cell of the top brick, by their boxes (a cell wider on every side, for rounding's sake).
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> deal_out(std::span<const std::uint32_t> items) const {
    std::vector<std::vector<std::uint32_t>> lists(kBrickCells);
    for (const std::uint32_t item : items) {
      const Box box = classifier_.item_bounds(item);
      int first[3], last[3];
      for (int axis = 0; axis < 3; ++axis) {
        const double most = grid_.dimensions[axis] - 1;
        const auto cell = [&](double x) { return std::floor((x - grid_.box.min[axis]) / grid_.cell_size); };
        first[axis] = static_cast<int>(std::clamp(cell(box.min[axis]) - 1, 0.0, most));
        last[axis] = static_cast<int>(std::clamp(cell(box.max[axis]) + 1, 0.0, most));
      }
      for (int k = first[2]; k <= last[2]; ++k) {
        for (int j = first[1]; j <= last[1]; ++j) {
          for (int i = first[0]; i <= last[0]; ++i) {
            lists[static_cast<std::size_t>((k * kBrickSide + j) * kBrickSide + i)].push_back(item);
          }
        }
      }
    }
    return lists;
  }

  void build_cell(std::uint32_t index, const Vec3& low, double size, std::span<const std::uint32_t> items, int depth) {
    std::vector<std::uint32_t>& kept = kept_[static_cast<std::size_t>(depth)];
    const Vec3 margin(size * 0x1p-20);
    const CellKind kind = classifier_.classify(Box(low - margin, low + Vec3(size) + margin), items, kept);
    if (kind != CellKind::leaf) {
      grid_.cells[index] = Cell::make(kind);
      return;
    }
    if (depth == kMaxGridDepth || !classifier_.should_divide(size, kept)) {
      grid_.cells[index] = Cell::make(CellKind::leaf, static_cast<std::uint32_t>(grid_.items.size()),
                                      static_cast<std::uint32_t>(kept.size()));
      grid_.items.insert(grid_.items.end(), kept.begin(), kept.end());
      grid_.longest_list = std::max(grid_.longest_list, static_cast<std::uint32_t>(kept.size()));
      return;
    }
    const auto first = static_cast<std::uint32_t>(grid_.cells.size());
    grid_.cells.resize(first + kBrickCells);
    grid_.cells[index] = Cell::make(CellKind::brick, first);
    const double child_size = size * (1.0 / kBrickSide);
    for (std::uint32_t child = 0; child < kBrickCells; ++child) {
      build_cell(first + child, low + corner(child) * child_size, child_size, kept, depth + 1);
    }
  }

  void mark_occupied() {
    grid_.occupied.resize(grid_.cells.size() / kBrickCells);
    for (std::size_t i = 0; i < grid_.cells.size(); ++i) {
      if (grid_.cells[i].kind() != CellKind::empty) grid_.occupied[i / kBrickCells] |= std::uint64_t{1} << (i % kBrickCells);
    }
  }

  Classifier& classifier_;
  Grid grid_;
  std::array<std::vector<std::uint32_t>, kMaxGridDepth + 1> kept_;
};

}  // namespace isl::render
