// Builds a Grid from the top down, level by level. A classifier decides how a cell is classified and whether it is
// worth dividing. Its members are called from several threads:
//
//   CellKind  classify(box, items, kept)   the kind of the cell, given the items of its parent; fills `kept` for a leaf
//   Division  division(size, kept)         the reason for dividing a leaf; size is its side
//   double    cost(kept)                   what a ray pays for the items of a leaf
//   size_t    most_entries(kept)           upper bound of the entries of a leaf's lists
//   Box       core(box, kept)              the part of a leaf that holds all there is in it; empty if nothing is
//   void      list(box, kept, lists)       one list for a leaf, or those of a choice: lists.add(numbers)
//   Box       item_bounds(item)            a box around all that the item touches
//
// A cell with a long list is divided on trial, and the trial is dropped if it gains nothing. Where large items overlap,
// smaller cells have the same lists, so a plate or thread among them would be followed down to its thickness, with 16
// times as many cells at every level. The gain is told by the surface area heuristic (MacDonald and Booth 1990): a ray
// that meets a cube meets one of the 64 cells in it with probability 1/16, the ratio of their surfaces, so it pays a
// sixteenth of the sum of the cells' costs. One level without a gain is allowed, because the next one may separate what
// this one does not.
//
// Besides, the whole grid has a limit. Cells are divided level by level and, where the limit is near, in the order of
// their cost, so that cells left undivided are small or cheap. Trials run side by side and are joined in a fixed order,
// so that the grid is the same whatever the number of threads.
#pragma once

#include "base/parallel.h"
#include "base/run_limits.h"
#include "renderer/grid/brick_part.h"
#include "renderer/grid/grid.h"
#include "renderer/grid/grid_budget.h"
#include "renderer/grid/top_brick.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace isl::render {

template <class Classifier>
class GridBuilder {
 public:
  /// `meter` is charged with the grid's memory while it is built. Once it refuses, the grid is empty. Null: without
  /// limit.
  GridBuilder(const Classifier& classifier, const GridCost& limit, Meter* meter = nullptr)
      : classifier_(classifier), maker_(classifier), limit_(limit), meter_(meter) {}

  /// `bounds` holds everything that has an end; its coordinates are within kFarthestInGrid. `items` are all item
  /// numbers, ascending. `has_endless`: some items have no end, so that every cell of the top brick must be classified,
  /// even one that a ray only grazes by a rounding.
  [[nodiscard]] Grid build(const Box& bounds, std::span<const std::uint32_t> items, bool has_endless = false) {
    cost_ = {};
    is_full_ = false;
    if (bounds.isEmpty() || items.empty()) return {};
    charge_ = new_charge();
    if (!may_hold(charge_, (items.back() + std::size_t{1}) * sizeof(Box))) return {};
    grid_ = top_brick_about(bounds, has_endless);
    boxes_ = widened_boxes(classifier_, items);
    Level level = top_brick(items);
    double size = grid_.cell_size;
    for (int depth = 0; !level.open.empty() && goes_on(); ++depth) {
      size *= 1.0 / kBrickSide;
      level = divided(level, size, depth + 1 < kMaxGridDepth && size > kLeastCell * grid_.rounding);
    }
    const std::size_t occupied_bytes = grid_.cells.size() / kBrickCells * sizeof(std::uint64_t);
    if (!may_hold(charge_, growth_of(grid_.items, grid_.items.size() + Grid::kListTail) + occupied_bytes)) return {};
    finish(has_endless);
    return std::move(grid_);
  }

  /// The cost of the grid that was built last.
  [[nodiscard]] const GridCost& cost() const { return cost_; }

 private:
  /// Cells of one size that may be divided.
  struct Level {
    std::vector<OpenCell> open;
    std::vector<std::uint32_t> kept;  ///< their items
    Charge charge;
  };

  /// Smaller cells, in units of Grid::rounding, are not divided: their parts would mostly be margin.
  static constexpr double kLeastCell = 64;
  static constexpr std::size_t kBrickBytes = kBrickCells * sizeof(Cell) + sizeof(std::uint64_t);

  [[nodiscard]] Level top_brick(std::span<const std::uint32_t> items) {
    const BrickCube cube{grid_.box.min, grid_.cell_size, grid_.rounding};
    Level level{.open = {}, .kept = {}, .charge = new_charge()};
    DealtItems dealt;
    Charge working = new_charge();
    if (!deal(cube, items, dealt, working)) return level;
    std::vector<Trial> cells(kBrickCells);
    parallel_for(kBrickCells, [&](std::size_t i) {
      const auto index = static_cast<std::uint32_t>(i);
      if (!is_in_use(grid_, index)) return;
      cells[i].charge = new_charge();
      if (may_add_children(cells[i], dealt[i].size(), 1)) add_child(cells[i], index, cube, dealt[i], true);
    });
    const std::uint32_t first = add_brick();
    for (const Trial& cell : cells) join(cell.part, first, false, level);
    return level;
  }

  /// Divides the cells of a level, as far as that gains anything and the limit allows it. Returns the next level.
  [[nodiscard]] Level divided(Level& level, double cell_size, bool may_divide) {
    if (cost_.bytes + bytes_if_all_are_divided(level) > limit_.bytes) put_dearest_first(level);
    Level next{.open = {}, .kept = {}, .charge = new_charge()};
    std::vector<Trial> trials;
    for (std::size_t begin = 0; begin < level.open.size() && goes_on();) {
      const bool is_spent = cost_.tests >= limit_.tests;
      const bool is_full = is_full_;
      const std::span<const OpenCell> batch = batch_from(level, begin);
      while (trials.size() < batch.size()) trials.emplace_back().charge = new_charge();
      parallel_for(batch.size(), [&](std::size_t i) {
        if (!goes_on()) return;
        const OpenCell& cell = batch[i];
        const std::span items = items_of(cell, level);
        const bool may_try = !is_spent && (!is_full || cell.entries > cell.count);
        if (!may_try || !divide(cell, items, cell_size, may_divide, trials[i])) stay(cell, items, cell_size, trials[i]);
        if (meter_ != nullptr) trials[i].count();
      });
      for (std::size_t i = 0; i < batch.size() && goes_on(); ++i) settle(batch[i], level, cell_size, trials[i], next);
      begin += batch.size();
    }
    return next;
  }

  /// The result for one cell: a brick, or the cell as a leaf; and working memory.
  struct Trial {
    bool is_brick = false, is_gain = false;
    std::size_t tests = 0;
    BrickPart part;
    DealtItems dealt;
    std::vector<std::uint32_t> kept;
    Charge charge;

    [[nodiscard]] std::size_t held_bytes() const {
      return part.held_bytes() + render::held_bytes(dealt) + kept.capacity() * sizeof(std::uint32_t);
    }
    /// Counts what is held, instead of what might have been needed.
    void count() {
      const std::size_t held = held_bytes();
      charge.add(held);
      charge.remove(charge.bytes() - held);
    }
  };

  /// True if dividing the cell is worth it.
  bool divide(const OpenCell& cell, std::span<const std::uint32_t> items, double cell_size, bool may_divide,
              Trial& trial) const {
    trial.part.clear();
    const BrickCube cube{cell.low, cell_size, grid_.rounding};
    if (!deal(cube, items, trial.dealt, trial.charge)) return false;
    std::size_t dealt = 0;
    for (const std::vector<std::uint32_t>& list : trial.dealt) dealt += list.size();
    if (!may_add_children(trial, dealt, kBrickCells)) return false;
    const bool must_gain = cell.must_gain && cell.is_stalled;
    const double most = kGain * kMetShare * cell.cost;
    for (std::uint32_t i = 0; i < kBrickCells && goes_on(); ++i) {
      add_child(trial, i, cube, trial.dealt[i], may_divide);
      if (must_gain && trial.part.cost >= most) break;
    }
    trial.tests = trial.part.tests;
    trial.is_gain = trial.part.cost < most;
    trial.is_brick = trial.is_gain || !must_gain;
    return trial.is_brick;
  }

  void stay(const OpenCell& cell, std::span<const std::uint32_t> items, double cell_size, Trial& trial) const {
    trial.is_brick = false;
    trial.part.clear();
    const std::size_t before = trial.part.list_bytes();
    maker_.add_leaf(trial.part, 0, {cell.low, cell_size * kBrickSide, grid_.rounding}, items);
    if (!may_hold(trial.charge, trial.part.list_bytes() - before)) trial.part.clear();
  }

  /// Joins a trial's result to the grid, if the limit allows it. Where items are in many branches, a cell may need more
  /// memory than the 64 that it is divided into.
  void settle(const OpenCell& cell, const Level& level, double cell_size, Trial& trial, Level& next) {
    cost_.tests += std::exchange(trial.tests, 0);
    const std::size_t undivided = cost_.bytes;
    cost_.bytes -= cell.bytes();
    if (trial.is_brick && cost_.bytes + kBrickBytes + trial.part.bytes() > std::max(limit_.bytes, undivided)) {
      is_full_ = true;
      stay(cell, items_of(cell, level), cell_size, trial);
    }
    if (trial.is_brick) {
      const std::uint32_t first = add_brick();
      grid_.cells[cell.cell] = Cell::make(CellKind::brick, first);
      join(trial.part, first, !trial.is_gain, next);
    } else {
      join(trial.part, cell.cell, false, next);
    }
  }
  [[nodiscard]] static std::span<const std::uint32_t> items_of(const OpenCell& cell, const Level& level) {
    return std::span(level.kept).subspan(cell.first, cell.count);
  }

  /// Adds a brick of empty cells and returns the index of its first one.
  std::uint32_t add_brick() {
    const auto first = static_cast<std::uint32_t>(grid_.cells.size());
    if (!may_hold(charge_, growth_of(grid_.cells, first + kBrickCells))) return 0;
    grid_.cells.resize(first + kBrickCells);
    cost_.bytes += kBrickBytes;
    return first;
  }

  /// Joins a part to the grid; its indices count from the cell `first`.
  void join(const BrickPart& part, std::uint32_t first, bool is_stalled, Level& level) {
    const auto first_item = static_cast<std::uint32_t>(grid_.items.size());
    const auto first_choice = static_cast<std::uint32_t>(grid_.choices.size());
    const std::size_t more = growth_of(grid_.items, grid_.items.size() + part.items.size()) +
                             growth_of(grid_.choices, grid_.choices.size() + part.choices.size());
    const std::size_t more_of_level = growth_of(level.open, level.open.size() + part.open.size()) +
                                      growth_of(level.kept, level.kept.size() + part.kept.size());
    if (!may_hold(charge_, more) || !may_hold(level.charge, more_of_level)) return;
    for (auto [index, cell] : part.finished) {
      if (cell.kind() == CellKind::leaf) cell.first += first_item;
      if (cell.kind() == CellKind::choice) cell.first += first_choice;
      grid_.cells[first + index] = cell;
    }
    grid_.items.insert(grid_.items.end(), part.items.begin(), part.items.end());
    for (const ItemList& list : part.choices) grid_.choices.push_back({list.first + first_item, list.count});
    grid_.longest_list = std::max(grid_.longest_list, part.longest_list);
    for (OpenCell open : part.open) {
      open.cell += first;
      open.first += level.kept.size();
      open.is_stalled = is_stalled;
      level.open.push_back(open);
    }
    level.kept.insert(level.kept.end(), part.kept.begin(), part.kept.end());
    cost_.bytes += part.bytes();
  }

  // ---- Memory -------------------------------------------------------------------------------------------------------

  [[nodiscard]] Charge new_charge() const { return meter_ != nullptr ? meter_->new_charge() : Charge(); }
  /// False once memory was refused or the run is stopped: what is made from then on is thrown away.
  [[nodiscard]] bool goes_on() const { return meter_ == nullptr || meter_->goes_on(); }
  [[nodiscard]] bool may_hold(Charge& charge, std::size_t bytes) const {
    return bytes == 0 ? goes_on() : meter_ == nullptr || meter_->grow(charge, bytes);
  }
  /// Bytes that a vector takes more to hold `count` elements. It grows to twice its size; while its elements move,
  /// their old places and the new ones in use are as many bytes.
  template <class T>
  [[nodiscard]] static std::size_t growth_of(const std::vector<T>& list, std::size_t count) {
    return count <= list.capacity() ? 0 : (std::max(2 * list.capacity(), count) - list.capacity()) * sizeof(T);
  }

  /// Deals the items out, as many at a time as little memory is needed for in any case.
  [[nodiscard]] bool deal(const BrickCube& cube, std::span<const std::uint32_t> items, DealtItems& dealt,
                          Charge& charge) const {
    constexpr std::size_t kTogether = 4096;
    for (std::vector<std::uint32_t>& list : dealt) list.clear();
    while (!items.empty()) {
      const std::span<const std::uint32_t> next = items.first(std::min(items.size(), kTogether));
      items = items.subspan(next.size());
      // Every item may reach every cell, and lists grow to twice their size.
      const std::size_t before = held_bytes(dealt);
      const std::size_t most = before + 2 * kBrickCells * next.size() * sizeof(std::uint32_t);
      if (!may_hold(charge, most)) return false;
      deal_out(cube, next, boxes_, dealt);
      if (meter_ != nullptr) charge.remove(most - (held_bytes(dealt) - before));
    }
    return true;
  }
  /// True if there is memory for `count` children with so many items, but for the lists of those that are leaves.
  [[nodiscard]] bool may_add_children(Trial& trial, std::size_t items, std::size_t count) const {
    using Finished = BrickPart::Finished;
    return may_hold(trial.charge,
                    2 * (2 * items * sizeof(std::uint32_t) + count * (sizeof(OpenCell) + sizeof(Finished))));
  }
  /// Adds a child. The lists of a leaf are counted once they are there, because their bound may be far from what they
  /// take where there are many branches.
  void add_child(Trial& trial, std::uint32_t index, const BrickCube& cube, std::span<const std::uint32_t> items,
                 bool may_divide) const {
    const std::size_t before = trial.part.list_bytes();
    maker_.add(trial.part, index, cube, items, may_divide, trial.kept);
    if (!may_hold(trial.charge, trial.part.list_bytes() - before)) trial.part.clear();
  }

  // ---- Limits -------------------------------------------------------------------------------------------------------

  /// An estimate: as many items in the new cells as rays meet in the old ones.
  [[nodiscard]] static std::size_t bytes_if_all_are_divided(const Level& level) {
    return level.open.size() * kBrickBytes + level.kept.size() * (std::size_t{kMetShare} * sizeof(std::uint32_t));
  }
  static void put_dearest_first(Level& level) {
    std::ranges::stable_sort(level.open, [](const OpenCell& a, const OpenCell& b) {
      return a.is_stalled != b.is_stalled ? b.is_stalled : a.cost > b.cost;
    });
  }

  /// The next cells that are tried together: at most kBatch, and not many more than the limit of tests and a part of
  /// the memory that is left allow.
  [[nodiscard]] std::span<const OpenCell> batch_from(const Level& level, std::size_t begin) const {
    std::size_t end = begin, tests = 0;
    const std::size_t left = cost_.tests < limit_.tests ? limit_.tests - cost_.tests : limit_.tests;
    // A test is that of an item in a cell, where it may be in a list that grows to twice its size.
    const std::size_t memory_left = meter_ != nullptr ? meter_->left() / (4 * 2 * sizeof(std::uint32_t)) : kNoLimit;
    const std::size_t most = std::max<std::size_t>(std::min(left, memory_left), 1);
    while (end < level.open.size() && end - begin < kBatch && tests < most)
      tests += kBrickCells * level.open[end++].count;
    return std::span(level.open).subspan(begin, end - begin);
  }

  /// Sets the cores of the bricks in a brick, whose cells have this size.
  void set_cores(std::uint32_t first, double size) {
    for (std::uint64_t left = grid_.occupied[first / kBrickCells]; left != 0; left &= left - 1) {
      Cell& cell = grid_.cells[first + static_cast<std::uint32_t>(std::countr_zero(left))];
      if (cell.kind() != CellKind::brick) continue;
      set_cores(cell.first, size * (1.0 / kBrickSide));
      cell.set_core(core_of_brick(grid_, cell.first), size, grid_.rounding);
    }
  }
  /// The core of the top brick.
  [[nodiscard]] Box core_box() const {
    const CellCore core = core_of_brick(grid_, 0);
    const double part = grid_.cell_size * kBrickSide / CellCore::kParts;
    Box box = grid_.box;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      box.min[axis] = grid_.box.min[axis] + core.from_low[i] * part;
      box.max[axis] =
          std::min(grid_.box.max[axis], grid_.box.min[axis] + (CellCore::kParts - core.from_high[i]) * part);
    }
    return box;
  }

  void finish(bool has_endless) {
    grid_.items.resize(grid_.items.size() + Grid::kListTail);
    grid_.occupied.resize(grid_.cells.size() / kBrickCells);
    for (std::size_t i = 0; i < grid_.cells.size(); ++i) {
      if (grid_.cells[i].kind() != CellKind::empty)
        grid_.occupied[i / kBrickCells] |= std::uint64_t{1} << (i % kBrickCells);
    }
    set_cores(0, grid_.cell_size);
    // An item without end is searched alone outside the core, and with all others inside it. Others may reach the whole
    // box and lower its field there, so that the core then has to be the box.
    grid_.core = has_endless ? grid_.box : core_box();
  }

  /// A trial gains if a ray pays less than this share of what it paid. Divisions of a sphereflake leave 0.1 to 0.7;
  /// those along a surface, where every list stays as it is, leave 1 if it lies along the axes and up to 1.5 if not.
  /// Lists that lose an item now and then leave 0.75 to 1: following them takes up to 20 times the memory, and rays are
  /// no faster.
  static constexpr double kGain = 0.75;
  /// A ray that meets a cube meets each of the 64 cells in it with probability 1/16.
  static constexpr int kMetShare = 16;
  /// Cells that are tried together: enough for many threads, few enough for their results to stay in the cache.
  static constexpr std::size_t kBatch = 256;
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

  const Classifier& classifier_;
  CellMaker<Classifier> maker_;
  GridCost limit_;
  GridCost cost_;
  Meter* meter_;
  Charge charge_;  ///< of the grid and the boxes
  Grid grid_;
  std::vector<Box> boxes_;  ///< by item
  bool is_full_ = false;
};

}  // namespace isl::render
