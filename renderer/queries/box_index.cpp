#include "renderer/queries/box_index.h"

#include "renderer/boxes/point_boxes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isl::render {

std::unique_ptr<const BoxIndex> BoxIndex::of(std::span<const Imath::Box3d> boxes, Budget* budget) {
  auto index = std::make_unique<BoxIndex>();
  index->charge_ = Charge(budget);
  Charge working(budget);
  if (!index->charge_.grow(sizeof(BoxIndex)) || !working.grow(boxes.size() * sizeof(std::uint32_t))) return nullptr;
  index->count_ = static_cast<std::uint32_t>(boxes.size());
  std::vector<std::uint32_t> bounded;
  bounded.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].isEmpty()) continue;
    if (fits_in_tree(boxes[i])) {
      bounded.push_back(i);
    } else if (index->charge_.grow(2 * sizeof(std::uint32_t))) {  // the list doubles as it grows
      index->everywhere_.push_back(i);
    } else {
      return nullptr;
    }
  }
  // So does the list of nodes.
  bool may_add = true;
  const auto add = [&] { return may_add = may_add && working.grow(2 * sizeof(BoxNode)); };
  index->tree_ = build_point_tree(boxes, std::move(bounded), add);
  if (!may_add || !index->charge_.grow(index->tree_.bytes())) return nullptr;
  return index;
}

void BoxIndex::append_around(const scene::Vec3& point, std::vector<std::uint32_t>& numbers) const {
  if (!std::isfinite(point.x + point.y + point.z)) [[unlikely]] {
    // A point that is no number is in no box, and yet has an answer.
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (!std::ranges::binary_search(everywhere_, i)) numbers.push_back(i);
    }
    return;
  }
  visit_boxes_around(tree_, point, [&](std::uint32_t i) { numbers.push_back(i); });
}

}  // namespace isl::render
