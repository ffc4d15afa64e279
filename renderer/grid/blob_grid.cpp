#include "renderer/grid/blob_grid.h"

#include "renderer/grid/grid_builder.h"

#include <numeric>

namespace isl::render {
namespace {

class FieldClassifier {
 public:
  FieldClassifier(const ComponentTable& table, bool classify) : table_(table), classify_(classify) {
    reach_.resize(table.size());
    for (const FieldGroup& group : table.groups) {
      for (std::uint32_t i = group.begin; i < group.end; ++i) reach_[i] = support_radius(table, group, i);
    }
  }

  CellKind classify(const Box& box, std::span<const std::uint32_t> items, std::vector<std::uint32_t>& kept) const {
    kept.clear();
    double low = 0, high = 0, magnitude = 0;
    auto group = table_.groups.begin();
    for (const std::uint32_t item : items) {
      while (item >= group->end) ++group;  // items ascend
      const FieldRange range = field_range(table_, *group, item, box);
      if (range.low == 0 && range.high == 0) continue;
      kept.push_back(item);
      low += range.low;
      high += range.high;
      magnitude += std::max(-range.low, range.high);
    }
    if (kept.empty()) return CellKind::empty;
    if (!classify_) return CellKind::leaf;
    // Each range is exact but for its rounding, a few units in the last place of the component's own value even where the
    // exponential magnifies its argument (hardness ≤ 500: 2⁹ units); the sum adds one a component.
    const double slack = magnitude * (0x1p-42 + 0x1p-52 * static_cast<double>(kept.size()));
    if (high < table_.threshold - slack) return CellKind::empty;
    if (low > table_.threshold + slack) return CellKind::inside;
    return CellKind::leaf;
  }

  [[nodiscard]] Box item_bounds(std::uint32_t item) const { return support_bounds(table_, table_.group_of(item), item); }

  /// Dividing pays while lists are longer than what one octet of lanes, or little more, evaluates at once; cells smaller than half
  /// the smallest support that reaches them only add steps.
  [[nodiscard]] bool should_divide(double size, const std::vector<std::uint32_t>& kept) const {
    if (kept.size() <= kShortList) return false;
    double least = reach_[kept.front()];
    for (const std::uint32_t item : kept) least = std::min(least, reach_[item]);
    return size > 0.5 * least;
  }

 private:
  // Measured on the 7,381 flake, quartic and Gaussian: flat from 6 to 16, with the quartic gaining towards 12.
  static constexpr std::size_t kShortList = 12;

  const ComponentTable& table_;
  bool classify_;
  std::vector<double> reach_;
};

}  // namespace

Grid build_blob_grid(const ComponentTable& table, const BlobGridOptions& options) {
  Box bounds;
  for (const FieldGroup& group : table.groups) {
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      // Where only negative fields reach there is no surface.
      if (table.amplitude[i] > 0) bounds.extendBy(support_bounds(table, group, i));
    }
  }
  std::vector<std::uint32_t> items(table.size());
  std::iota(items.begin(), items.end(), 0u);
  FieldClassifier classifier(table, options.classify);
  return GridBuilder(classifier).build(bounds, items);
}

}  // namespace isl::render
