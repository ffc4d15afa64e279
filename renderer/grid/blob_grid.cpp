#include "renderer/grid/blob_grid.h"

#include "renderer/grid/field_classifier.h"
#include "renderer/grid/grid_builder.h"

#include <limits>
#include <numeric>
#include <utility>

namespace isl::render {
namespace {

/// Adds one cell for all that lies beyond the grid's box, where half-spaces and sheets still reach.
void add_beyond(const FieldClassifier& classifier, std::vector<std::uint32_t> endless_items, Grid& grid) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Box everywhere{Vec3(-kFar), Vec3(kFar)};
  std::vector<std::uint32_t> kept;
  if (endless_items.empty() || classifier.classify(everywhere, endless_items, kept) == CellKind::empty) return;
  grid.endless_items = std::move(endless_items);
  grid.items.resize(grid.list_entries());
  ListSink sink(grid.items);
  classifier.list(everywhere, kept, sink);
  grid.items.resize(grid.items.size() + Grid::kListTail);
  grid.beyond = static_cast<std::uint32_t>(grid.cells.size());
  grid.cells.push_back(cell_of(sink.lists(), grid.choices));
}

/// The part of a box in which fields can be evaluated. Squares of distances within it do not overflow: 3 (2·2⁵¹⁰)² is
/// less than 2¹⁰²⁴. A component may reach farther, or its box may be no number.
Box where_fields_are_numbers(Box box) {
  constexpr double kFarthest = 0x1p510;
  static_assert(kFarthest <= kFarthestInGrid);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] >= -kFarthest)) box.min[axis] = -kFarthest;
    if (!(box.max[axis] <= kFarthest)) box.max[axis] = kFarthest;
  }
  return box;
}

}  // namespace

Grid build_blob_grid(const ComponentTable& table, CellRule rule, GridBudget& budget, Meter* meter) {
  std::vector<std::uint32_t> endless_items;
  for (const FieldGroup& group : table.groups) {
    if (!scene::is_endless(group.skeleton)) continue;
    for (std::uint32_t i = group.begin; i < group.end; ++i) endless_items.push_back(i);
  }
  Box bounds;
  for (const FieldGroup& group : table.groups) {
    if (scene::is_endless(group.skeleton)) continue;
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      // Negative fields alone make no surface, unless they carve something endless.
      if (table.amplitude[i] > 0 || !endless_items.empty())
        bounds.extendBy(where_fields_are_numbers(support_bounds(table, group, i)));
    }
  }
  std::vector<std::uint32_t> items(table.size());
  std::iota(items.begin(), items.end(), 0u);
  FieldClassifier classifier(table, rule);
  GridBuilder builder(classifier, limit_of(budget, items.size(), meter), meter);
  Grid grid = builder.build(bounds, items, !endless_items.empty());
  if (meter != nullptr && !meter->goes_on()) return {};
  budget.spend(items.size(), builder.cost());
  add_beyond(classifier, std::move(endless_items), grid);
  grid.shrink_to_fit();
  return grid;
}

}  // namespace isl::render
