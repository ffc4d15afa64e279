// Builds a Grid from the top down. A classifier decides how a cell is classified and whether dividing it pays. Its
// members are called from several threads:
//
//   CellKind  classify(box, items, kept)   the kind of the cell, given the items of its parent; fills `kept` for a leaf
//   bool      should_divide(size, kept)    true if a leaf is worth dividing; size is its side
//   void      list(box, kept, lists)       one list for a leaf, or those of a choice: lists.add(numbers)
//   Box       item_bounds(item)            a box around all that the item touches
//
// A box is handed over enlarged by 2⁻²⁰ of its size on every side, so that the rounding of a ray's position (a few
// units in the last place of the grid's extent) never decides which items a point sees. The 64 cells of the top brick
// are built side by side and joined in their order, so that the grid is the same whatever the number of threads.
#pragma once

#include "base/parallel.h"
#include "renderer/grid/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace isl::render {

/// Receives the lists of a cell from a classifier.
class ListSink {
 public:
  explicit ListSink(std::vector<std::uint32_t>& items) : items_(items) {}
  void add(std::span<const std::uint32_t> numbers) {
    lists_.push_back({static_cast<std::uint32_t>(items_.size()), static_cast<std::uint32_t>(numbers.size())});
    items_.insert(items_.end(), numbers.begin(), numbers.end());
  }
  [[nodiscard]] std::span<const ItemList> lists() const { return lists_; }

 private:
  std::vector<std::uint32_t>& items_;
  std::vector<ItemList> lists_;
};

/// The cell that has these lists; several lists are appended to `choices`.
[[nodiscard]] inline Cell cell_of(std::span<const ItemList> lists, std::vector<ItemList>& choices) {
  if (lists.size() == 1) return Cell::make(CellKind::leaf, lists[0].first, lists[0].count);
  const Cell cell = Cell::make(CellKind::choice, static_cast<std::uint32_t>(choices.size()),
                               static_cast<std::uint32_t>(lists.size()));
  choices.insert(choices.end(), lists.begin(), lists.end());
  return cell;
}

template <class Classifier>
class GridBuilder {
 public:
  explicit GridBuilder(const Classifier& classifier) : classifier_(classifier) {}

  /// `bounds` holds everything that has an end; `items` are all item numbers, ascending. `has_endless`: some items have
  /// no end, so that every cell of the top brick must be classified, even one that a ray only grazes by a rounding.
  [[nodiscard]] Grid build(const Box& bounds, std::span<const std::uint32_t> items, bool has_endless = false) {
    grid_ = {};
    if (bounds.isEmpty() || items.empty()) return std::move(grid_);
    lay_out_top_brick(bounds, has_endless);
    const std::vector<std::vector<std::uint32_t>> lists = deal_out(items);
    std::vector<Part> parts(kBrickCells);
    parallel_for(kBrickCells, [&](std::size_t index) {
      if (lists[index].empty()) return;
      const Vec3 low = grid_.box.min + corner(static_cast<std::uint32_t>(index)) * grid_.cell_size;
      parts[index].top = build_cell(parts[index], low, grid_.cell_size, lists[index], 0);
    });
    join(parts);
    mark_occupied();
    return std::move(grid_);
  }

 private:
  /// The content of one cell of the top brick. Indices count from the part's own beginning.
  struct Part {
    Cell top;
    std::vector<Cell> cells;
    std::vector<std::uint32_t> items;
    std::vector<ItemList> choices;
    std::uint32_t longest_list = 0;
    std::array<std::vector<std::uint32_t>, kMaxGridDepth + 1> kept;  ///< working memory, by depth
  };

  /// Lays out cubic cells, four along the longest side of the content and centred on it. They are wider by 2⁻²⁰, as
  /// every cell is.
  void lay_out_top_brick(const Box& bounds, bool has_endless) {
    const Vec3 size = bounds.size();
    const double longest = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
    grid_.bounds = bounds;
    grid_.cell_size = longest * (1 + 0x1p-20) / kBrickSide;
    Vec3 half;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = std::ceil(size[axis] / grid_.cell_size);
      const int needed = cells < kBrickSide ? std::max(static_cast<int>(cells), 1) : kBrickSide;
      grid_.dimensions[axis] = has_endless ? kBrickSide : needed;
      half[axis] = 0.5 * grid_.cell_size * grid_.dimensions[axis];
    }
    grid_.box = Box(bounds.center() - half, bounds.center() + half);
  }

  [[nodiscard]] static Vec3 corner(std::uint32_t index) {
    const std::uint32_t row = index / kBrickSide, layer = row / kBrickSide;
    return {double(index % kBrickSide), double(row % kBrickSide), double(layer)};
  }

  /// The items that may touch each cell of the top brick, by their boxes. One more cell on every side allows for
  /// rounding.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> deal_out(std::span<const std::uint32_t> items) const {
    std::vector<std::vector<std::uint32_t>> lists(kBrickCells);
    for (const std::uint32_t item : items) {
      const Box box = classifier_.item_bounds(item);
      std::size_t first[3], last[3];
      for (int axis = 0; axis < 3; ++axis) {
        const double most = grid_.dimensions[axis] - 1;
        const auto cell = [&](double x) { return std::floor((x - grid_.box.min[axis]) / grid_.cell_size); };
        // Each comparison is false for a number that is none, as coordinates near the end of double precision give it:
        // the item is in all cells then.
        const double low = cell(box.min[axis]) - 1, high = cell(box.max[axis]) + 1;
        first[axis] = low > 0 ? static_cast<std::size_t>(std::min(low, most)) : 0;
        last[axis] = static_cast<std::size_t>(high < most ? std::max(high, 0.0) : most);
      }
      for (std::size_t k = first[2]; k <= last[2]; ++k) {
        for (std::size_t j = first[1]; j <= last[1]; ++j) {
          for (std::size_t i = first[0]; i <= last[0]; ++i) {
            lists[(k * kBrickSide + j) * kBrickSide + i].push_back(item);
          }
        }
      }
    }
    return lists;
  }

  [[nodiscard]] Cell build_cell(Part& part, const Vec3& low, double size, std::span<const std::uint32_t> items,
                                int depth) const {
    std::vector<std::uint32_t>& kept = part.kept[static_cast<std::size_t>(depth)];
    const Vec3 margin(size * 0x1p-20);
    const Box box(low - margin, low + Vec3(size) + margin);
    const CellKind kind = classifier_.classify(box, items, kept);
    if (kind != CellKind::leaf) return Cell::make(kind);
    if (depth == kMaxGridDepth || !classifier_.should_divide(size, kept)) {
      ListSink sink(part.items);
      classifier_.list(box, kept, sink);
      for (const ItemList& list : sink.lists()) part.longest_list = std::max(part.longest_list, list.count);
      return cell_of(sink.lists(), part.choices);
    }
    const auto first = static_cast<std::uint32_t>(part.cells.size());
    part.cells.resize(first + kBrickCells);
    const double child_size = size * (1.0 / kBrickSide);
    for (std::uint32_t child = 0; child < kBrickCells; ++child) {
      // `cells` may be reallocated while a child is built.
      const Cell cell = build_cell(part, low + corner(child) * child_size, child_size, kept, depth + 1);
      part.cells[first + child] = cell;
    }
    return Cell::make(CellKind::brick, first);
  }

  /// Appends the parts behind the top brick, one after another.
  void join(std::vector<Part>& parts) {
    std::size_t cells = kBrickCells, items = Grid::kListTail;
    for (const Part& part : parts) {
      cells += part.cells.size();
      items += part.items.size();
    }
    grid_.cells.reserve(cells);
    grid_.items.reserve(items);
    grid_.cells.resize(kBrickCells);
    for (std::size_t i = 0; i < kBrickCells; ++i) {
      Part& part = parts[i];
      const auto first_cell = static_cast<std::uint32_t>(grid_.cells.size());
      const auto first_item = static_cast<std::uint32_t>(grid_.items.size());
      const auto first_choice = static_cast<std::uint32_t>(grid_.choices.size());
      const auto shifted = [&](Cell cell) {
        if (cell.kind() == CellKind::brick) cell.first += first_cell;
        if (cell.kind() == CellKind::leaf) cell.first += first_item;
        if (cell.kind() == CellKind::choice) cell.first += first_choice;
        return cell;
      };
      grid_.cells[i] = shifted(part.top);
      for (const Cell& cell : part.cells) grid_.cells.push_back(shifted(cell));
      grid_.items.insert(grid_.items.end(), part.items.begin(), part.items.end());
      for (const ItemList& list : part.choices) grid_.choices.push_back({list.first + first_item, list.count});
      grid_.longest_list = std::max(grid_.longest_list, part.longest_list);
      part = {};
    }
    grid_.items.resize(grid_.items.size() + Grid::kListTail);
  }

  void mark_occupied() {
    grid_.occupied.resize(grid_.cells.size() / kBrickCells);
    for (std::size_t i = 0; i < grid_.cells.size(); ++i) {
      if (grid_.cells[i].kind() != CellKind::empty)
        grid_.occupied[i / kBrickCells] |= std::uint64_t{1} << (i % kBrickCells);
    }
  }

  const Classifier& classifier_;
  Grid grid_;
};

}  // namespace isl::render
