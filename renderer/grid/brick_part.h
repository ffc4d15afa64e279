// Makes the cells of a brick from the items of the cell that it divides: each child gets the items whose boxes reach
// it, and is classified. The builder (grid_builder.h) joins what is made here into a grid.
#pragma once

#include "renderer/grid/grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

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

/// The reason for dividing a leaf.
enum class Division : std::uint8_t {
  none,
  size,  ///< it is larger than what is in it; smaller cells are better even with the same lists
  lists  ///< its list is long; smaller cells are only better with shorter lists
};

/// A leaf that is large or crowded enough to be divided.
struct OpenCell {
  Vec3 low;             ///< its corner
  std::size_t first;    ///< its items, in an array that belongs to its level
  std::uint32_t count;  ///< number of its items
  std::uint32_t cell;   ///< index of the cell
  std::size_t entries;  ///< most entries of the lists that it would have as a leaf
  double cost;          ///< what a ray pays for its items
  bool must_gain;       ///< it is divided for the sake of shorter lists
  bool is_stalled;      ///< dividing its parent did not lower the cost of a ray

  /// Bytes that it takes while it is open, and at most as a leaf.
  [[nodiscard]] std::size_t bytes() const { return sizeof(OpenCell) + entries * sizeof(std::uint32_t); }
};

/// Cells of one brick. Indices count from the beginning of the brick and of the arrays here.
struct BrickPart {
  struct Finished {
    std::uint32_t index;
    Cell cell;
  };
  std::vector<Finished> finished;  ///< cells that stay as they are; those that are not empty
  std::vector<std::uint32_t> items;
  std::vector<ItemList> choices;
  std::vector<OpenCell> open;
  std::vector<std::uint32_t> kept;  ///< items of the open cells
  double cost = 0;                  ///< sum of what rays pay for the cells
  std::size_t tests = 0;            ///< classifications of an item in a cell
  std::uint32_t longest_list = 0;

  void clear() {
    finished.clear();
    items.clear();
    choices.clear();
    open.clear();
    kept.clear();
    cost = 0;
    tests = 0;
    longest_list = 0;
  }
  /// Bytes that the part takes, with the places that wait for more.
  [[nodiscard]] std::size_t held_bytes() const {
    return list_bytes() + finished.capacity() * sizeof(Finished) + open.capacity() * sizeof(OpenCell) +
           kept.capacity() * sizeof(std::uint32_t);
  }
  [[nodiscard]] std::size_t list_bytes() const {
    return items.capacity() * sizeof(std::uint32_t) + choices.capacity() * sizeof(ItemList);
  }
  /// Bytes of the lists, if no open cell is divided.
  [[nodiscard]] std::size_t bytes() const {
    std::size_t bytes = items.size() * sizeof(std::uint32_t) + choices.size() * sizeof(ItemList);
    for (const OpenCell& cell : open) bytes += cell.bytes();
    return bytes;
  }
};

/// A cube that is divided into the cells of a brick.
struct BrickCube {
  Vec3 low;
  double cell_size;
  double rounding;  ///< Grid::rounding

  [[nodiscard]] Vec3 corner(std::uint32_t index) const {
    const std::uint32_t row = index / kBrickSide, layer = row / kBrickSide;
    return low + Vec3(double(index % kBrickSide), double(row % kBrickSide), double(layer)) * cell_size;
  }
  /// The width by which a cell's box is enlarged on every side, so that the rounding of a ray's position never decides
  /// which items a point sees: 2⁻²⁰ of its size, or Grid::rounding if that is more.
  [[nodiscard]] double margin() const { return std::max(cell_size * 0x1p-20, rounding); }
  /// The enlarged box of a cell.
  [[nodiscard]] Box box(std::uint32_t index) const {
    const Vec3 from = corner(index), wider(margin());
    return Box(from - wider, from + Vec3(cell_size) + wider);
  }
};

/// The core of the brick with this first cell: the least that contains those of its cells.
[[nodiscard]] inline CellCore core_of_brick(const Grid& grid, std::uint32_t first) {
  constexpr unsigned kParts = kBrickSide * CellCore::kParts;
  unsigned low[3] = {kParts, kParts, kParts}, high[3] = {kParts, kParts, kParts};
  for (std::uint64_t left = grid.occupied[first / kBrickCells]; left != 0; left &= left - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(left));
    const Cell& cell = grid.cells[first + i];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned slab = i >> (2 * axis) & 3;
      low[axis] = std::min(low[axis], slab * CellCore::kParts + cell.core.from_low[axis]);
      high[axis] = std::min(high[axis], (kBrickSide - 1 - slab) * CellCore::kParts + cell.core.from_high[axis]);
    }
  }
  CellCore core;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const unsigned from_low = std::min(low[axis] / kBrickSide, CellCore::kParts - 1U);
    core.from_low[axis] = static_cast<std::uint8_t>(from_low);
    core.from_high[axis] =
        static_cast<std::uint8_t>(std::min(high[axis] / kBrickSide, CellCore::kParts - 1U - from_low));
  }
  return core;
}

/// The items of each cell of a brick.
using DealtItems = std::array<std::vector<std::uint32_t>, kBrickCells>;

[[nodiscard]] inline std::size_t held_bytes(const DealtItems& dealt) {
  std::size_t places = 0;
  for (const std::vector<std::uint32_t>& list : dealt) places += list.capacity();
  return places * sizeof(std::uint32_t);
}

/// Deals items out to the cells of a brick that their boxes reach, after those that are there. `boxes` is indexed by
/// item. An item whose box is not a number reaches every cell.
inline void deal_out(const BrickCube& cube, std::span<const std::uint32_t> items, std::span<const Box> boxes,
                     DealtItems& dealt) {
  double begin[3][kBrickSide], end[3][kBrickSide];  // of the enlarged cells
  for (std::uint32_t i = 0; i < kBrickSide; ++i) {
    const Box cell = cube.box(i * (1 + kBrickSide + kBrickSide * kBrickSide));
    for (int axis = 0; axis < 3; ++axis) {
      begin[axis][i] = cell.min[axis];
      end[axis][i] = cell.max[axis];
    }
  }
  for (const std::uint32_t item : items) {
    const Box& box = boxes[item];
    unsigned first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
      const auto& from = begin[axis];
      const auto& to = end[axis];
      const double low = box.min[axis], high = box.max[axis];
      first[axis] = (to[0] < low) + (to[1] < low) + (to[2] < low);
      last[axis] = 3U - (from[1] > high) - (from[2] > high) - (from[3] > high);
    }
    for (unsigned z = first[2]; z <= last[2]; ++z) {
      for (unsigned y = first[1]; y <= last[1]; ++y) {
        for (unsigned x = first[0]; x <= last[0]; ++x) dealt[(z * kBrickSide + y) * kBrickSide + x].push_back(item);
      }
    }
  }
}

/// Classifies cells and adds them to parts of bricks.
template <class Classifier>
class CellMaker {
 public:
  explicit CellMaker(const Classifier& classifier) : classifier_(classifier) {}

  /// Adds a cell that holds some of `items`; if it may be divided, as an open one. `kept` is working memory.
  void add(BrickPart& part, std::uint32_t index, const BrickCube& cube, std::span<const std::uint32_t> items,
           bool may_divide, std::vector<std::uint32_t>& kept) const {
    if (items.empty()) return;
    part.tests += items.size();
    const Box box = cube.box(index);
    const CellKind kind = classifier_.classify(box, items, kept);
    if (kind == CellKind::empty) return;
    if (kind != CellKind::leaf) return part.finished.push_back({index, Cell::make(kind)});
    const double cost = classifier_.cost(kept);
    part.cost += cost;
    const Division division = may_divide ? classifier_.division(cube.cell_size, kept) : Division::none;
    if (division == Division::none) return add_leaf(part, index, cube, kept);
    part.open.push_back({cube.corner(index), part.kept.size(), static_cast<std::uint32_t>(kept.size()), index,
                         classifier_.most_entries(kept), cost, division == Division::lists, false});
    part.kept.insert(part.kept.end(), kept.begin(), kept.end());
  }

  /// Adds a leaf that holds all of these items, if there is anything in it.
  void add_leaf(BrickPart& part, std::uint32_t index, const BrickCube& cube,
                std::span<const std::uint32_t> items) const {
    const Box box = cube.box(index), core = classifier_.core(box, items);
    if (core.isEmpty()) return;
    ListSink sink(part.items);
    classifier_.list(box, items, sink);
    for (const ItemList& list : sink.lists()) part.longest_list = std::max(part.longest_list, list.count);
    Cell cell = cell_of(sink.lists(), part.choices);
    if (core == box) return part.finished.push_back({index, cell});
    cell.set_core(CellCore::around(core, cube.corner(index), cube.cell_size, cube.margin()), cube.cell_size,
                  cube.rounding);
    part.finished.push_back({index, cell});
  }

 private:
  const Classifier& classifier_;
};

}  // namespace isl::render
