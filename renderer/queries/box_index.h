// Tells which of many things can matter at a point: those whose boxes hold it.
#pragma once

#include "base/budget.h"
#include "renderer/boxes/box_tree.h"
#include "renderer/scene/transform.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace isl::render {

/// Immutable.
class BoxIndex {
 public:
  /// Things with empty boxes matter nowhere. Null if the budget does not have the memory; it may be null, too.
  [[nodiscard]] static std::unique_ptr<const BoxIndex> of(std::span<const Imath::Box3d> boxes, Budget* budget);

  /// The numbers of the things whose boxes are too large for a tree.
  [[nodiscard]] std::span<const std::uint32_t> everywhere() const { return everywhere_; }
  /// Appends the numbers of all others whose boxes hold the point.
  void append_around(const scene::Vec3& point, std::vector<std::uint32_t>& numbers) const;

  [[nodiscard]] std::size_t bytes() const { return charge_.bytes(); }

 private:
  BoxTree tree_;
  std::vector<std::uint32_t> everywhere_;
  std::uint32_t count_ = 0;  ///< of all things
  Charge charge_;
};

}  // namespace isl::render
