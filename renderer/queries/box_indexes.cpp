#include "renderer/queries/box_indexes.h"

#include "renderer/queries/set_logic.h"

#include <limits>
#include <utility>

namespace isl::render {
namespace {

using Imath::Box3d;

/// Building an index takes about as long as this many questions without one, whatever the number of parts, so that
/// whoever stops asking has waited at most twice as long as the questions alone take.
constexpr std::uint32_t kQuestionsBefore = 32;

}  // namespace

template <class Index>
template <class Build>
const Index* BoxIndexes::Slot<Index>::get(std::mutex& building, const Build& build) {
  if (const Index* const ready = ready_.load(std::memory_order_acquire)) return ready;
  if (questions_.fetch_add(1, std::memory_order_relaxed) + 1 < kQuestionsBefore) return nullptr;
  const std::unique_lock lock(building, std::try_to_lock);
  if (!lock) return nullptr;  // another thread builds; this one goes on without
  if (!index_) {
    questions_.store(0, std::memory_order_relaxed);
    index_ = build();
    ready_.store(index_.get(), std::memory_order_release);
  }
  return index_.get();
}

void BoxIndexes::follow() {
  while (blobs_.size() < database_.blobs.size()) blobs_.emplace_back();
  while (groups_.size() < database_.groups.size()) groups_.emplace_back();
}

const BoxIndexes::OfBlob* BoxIndexes::of_blob(std::uint32_t blob) {
  return blobs_[blob].get(building_, [&] { return build_blob(database_.blobs[blob]); });
}

const BoxIndex* BoxIndexes::of_group(std::uint32_t group, bool is_inverse) {
  return groups_[group][is_inverse].get(building_, [&] { return build_group(database_.groups[group], is_inverse); });
}

std::unique_ptr<const BoxIndexes::OfBlob> BoxIndexes::build_blob(const scene::Blob& blob) {
  Charge working(run_.budget), charge(run_.budget);
  if (!working.grow(blob.components.size() * sizeof(Box3d))) return nullptr;
  if (!charge.grow(BranchSums::bytes(blob.branches.size()))) return nullptr;
  std::vector<Box3d> boxes;
  boxes.reserve(blob.components.size());
  for (const scene::Component& c : blob.components)
    boxes.push_back(support_box(database_, blob, c, kernels_[index(c.kernel)]));
  std::unique_ptr<const BoxIndex> components = BoxIndex::of(boxes, run_.budget);
  if (!components) return nullptr;
  return std::unique_ptr<const OfBlob>(
      new OfBlob{std::move(components), BranchSums({blob.branches.begin(), blob.branches.end()}), std::move(charge)});
}

std::unique_ptr<const BoxIndex> BoxIndexes::build_group(const scene::Group& group, bool is_inverse) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Charge working(run_.budget);
  if (!working.grow(group.children.size() * sizeof(Box3d))) return nullptr;
  std::vector<Box3d> boxes;
  boxes.reserve(group.children.size());
  const bool neutral = wants_all(group, is_inverse);
  for (std::size_t i = 0; i < group.children.size(); ++i) {
    const Enclosure child = enclosures_.of(group.children[i], is_asked_inverse(group, i, is_inverse));
    boxes.push_back(child.beyond == neutral ? child.box : Box3d(scene::Vec3(-kFar), scene::Vec3(kFar)));
  }
  return BoxIndex::of(boxes, run_.budget);
}

}  // namespace isl::render
