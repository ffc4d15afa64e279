// Items are divided in two where the surface area heuristic (MacDonald and Booth 1990) expects the least work, by bins
// of their centres (Wald 2007, On fast Construction of SAH-based Bounding Volume Hierarchies). A node takes eight
// parts, each found by dividing the part with the largest surface before it. (A tree for points is divided by number.)
#include "renderer/boxes/box_tree.h"

#include "renderer/boxes/point_boxes.h"
#include "renderer/scene/transform.h"

#include <algorithm>
#include <array>
#include <limits>

namespace isl::render {
namespace {

using Box = Imath::Box3d;
using scene::Vec3;

/// Nodes below this depth halve the number of their items: 2³¹ items end after at most 31 further ones.
constexpr std::size_t kDepthOfHeuristic = kDeepestBoxTree - 32;

double surface(const Box& box) {
  if (box.isEmpty()) return 0;
  const Vec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// How the items of a node are divided into its children.
enum class Division : std::uint8_t { by_surface, by_number };

/// A part of the list of items.
struct Part {
  std::size_t first = 0, last = 0;
  Box bounds;
  [[nodiscard]] std::size_t size() const { return last - first; }
};

class Builder {
 public:
  Builder(std::span<const Box> boxes, std::vector<std::uint32_t> items, const std::function<bool()>& may_add,
          Division division)
      : boxes_(boxes), items_(std::move(items)), may_add_(may_add), division_(division) {}

  BoxTree run() {
    if (!items_.empty()) add(part(0, items_.size()), 0);
    tree_.nodes.shrink_to_fit();
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Part part(std::size_t first, std::size_t last) const {
    Part result{first, last, {}};
    for (std::size_t i = first; i < last; ++i) result.bounds.extendBy(boxes_[items_[i]]);
    return result;
  }
  [[nodiscard]] double centre(std::uint32_t item, int axis) const {
    return boxes_[item].min[axis] / 2 + boxes_[item].max[axis] / 2;
  }

  std::uint32_t add(const Part& whole, std::size_t depth) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    if (!may_add_()) return index;
    BoxNode& empty = tree_.nodes.emplace_back();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (auto& axis : empty.planes) {
      std::ranges::fill(axis[0], kInfinite);
      std::ranges::fill(axis[1], -kInfinite);
    }
    std::ranges::fill(empty.children, BoxNode::kItem);
    std::array<Part, kBoxChildren> parts{whole};
    std::size_t count = 1;
    const std::size_t least = division_ == Division::by_number ? items_of_full_child(whole.size()) : 1;
    for (; count < kBoxChildren; ++count) {
      Part* widest = nullptr;
      for (Part& one : std::span(parts).first(count)) {
        if (one.size() > least && (widest == nullptr || surface(one.bounds) > surface(widest->bounds))) widest = &one;
      }
      if (widest == nullptr) break;
      const bool by_surface = division_ == Division::by_surface && depth < kDepthOfHeuristic;
      const std::size_t middle = by_surface ? divide(*widest) : halve(*widest, least);
      parts[count] = part(middle, widest->last);
      *widest = part(widest->first, middle);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t child =
          parts[i].size() == 1 ? items_[parts[i].first] | BoxNode::kItem : add(parts[i], depth + 1);
      BoxNode& node = tree_.nodes[index];
      node.children[i] = child;
      for (int axis = 0; axis < 3; ++axis) {
        node.planes[axis][0][i] = parts[i].bounds.min[axis];
        node.planes[axis][1][i] = parts[i].bounds.max[axis];
      }
    }
    return index;
  }

  /// The items below a child of a node, if all its nodes are full.
  [[nodiscard]] static std::size_t items_of_full_child(std::size_t items) {
    std::size_t full = 1;
    while (full * kBoxChildren < items) full *= kBoxChildren;
    return full;
  }

  /// Orders the items by their centres along the longest side, and returns the middle, a multiple of `unit` items from
  /// the first one.
  std::size_t halve(const Part& whole, std::size_t unit) {
    const auto axis = static_cast<int>(whole.bounds.majorAxis());
    const std::size_t middle = whole.first + (whole.size() / 2 + unit - 1) / unit * unit;
    const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(whole.first), at(middle), at(whole.last),
                     [&](std::uint32_t a, std::uint32_t b) { return centre(a, axis) < centre(b, axis); });
    return middle;
  }

  struct Cut {
    int axis = -1;
    std::size_t bin = 0;  ///< the first one behind the cut
    double cost = std::numeric_limits<double>::infinity();
  };

  static constexpr std::size_t kBins = 16;

  /// The bins along an axis of the centres' bounds.
  struct Bins {
    double low, per_length;
    [[nodiscard]] std::size_t of(double centre) const {
      const double bin = (centre - low) * per_length;
      return bin < kBins ? static_cast<std::size_t>(bin) : kBins - 1;
    }
  };
  [[nodiscard]] static Bins bins_of(const Box& centres, int axis) {
    return {centres.min[axis], kBins / (centres.max[axis] - centres.min[axis])};
  }

  /// The cheapest place to divide, or the middle where all centres are one.
  std::size_t divide(const Part& whole) {
    Box centres;
    for (std::size_t i = whole.first; i < whole.last; ++i) {
      const std::uint32_t item = items_[i];
      centres.extendBy(Vec3(centre(item, 0), centre(item, 1), centre(item, 2)));
    }
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      if (centres.max[axis] > centres.min[axis]) try_axis(whole, axis, bins_of(centres, axis), best);
    }
    if (best.axis < 0) return halve(whole, 1);
    const Bins bins = bins_of(centres, best.axis);
    const auto begin = items_.begin();
    const auto middle = std::partition(begin + static_cast<std::ptrdiff_t>(whole.first),
                                       begin + static_cast<std::ptrdiff_t>(whole.last),
                                       [&](std::uint32_t item) { return bins.of(centre(item, best.axis)) < best.bin; });
    return static_cast<std::size_t>(middle - begin);
  }

  void try_axis(const Part& whole, int axis, const Bins& bins, Cut& best) const {
    std::array<Box, kBins> boxes;
    std::array<std::size_t, kBins> counts{};
    for (std::size_t i = whole.first; i < whole.last; ++i) {
      const std::size_t bin = bins.of(centre(items_[i], axis));
      boxes[bin].extendBy(boxes_[items_[i]]);
      ++counts[bin];
    }
    std::array<double, kBins> behind{};  // the cost of all bins from this one on
    std::array<std::size_t, kBins> left{};
    Box bounds;
    std::size_t count = 0;
    for (std::size_t bin = kBins; bin-- > 1;) {
      bounds.extendBy(boxes[bin]);
      count += counts[bin];
      behind[bin] = surface(bounds) * static_cast<double>(count);
      left[bin] = count;
    }
    bounds = {};
    count = 0;
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      bounds.extendBy(boxes[bin - 1]);
      count += counts[bin - 1];
      if (count == 0 || left[bin] == 0) continue;
      const double cost = surface(bounds) * static_cast<double>(count) + behind[bin];
      if (cost < best.cost) best = {axis, bin, cost};
    }
  }

  std::span<const Box> boxes_;
  std::vector<std::uint32_t> items_;
  const std::function<bool()>& may_add_;
  Division division_;
  BoxTree tree_;
};

}  // namespace

bool fits_in_tree(const Box& box) {
  constexpr double kFarthest = 1e90;
  if (box.isEmpty()) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] >= -kFarthest && box.max[axis] <= kFarthest)) return false;
  }
  return true;
}

BoxTree build_box_tree(std::span<const Box> boxes, std::vector<std::uint32_t> items,
                       const std::function<bool()>& may_add) {
  return Builder(boxes, std::move(items), may_add, Division::by_surface).run();
}

BoxTree build_point_tree(std::span<const Box> boxes, std::vector<std::uint32_t> items,
                         const std::function<bool()>& may_add) {
  return Builder(boxes, std::move(items), may_add, Division::by_number).run();
}

}  // namespace isl::render
