#include "renderer/paths/direction_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace isl::render {
namespace {

/// Cells of directions: 16 in each octant, so that each has some eight of a thousand rays.
constexpr std::size_t kCells = 128;

/// The cell of a direction of any length but 0. Neighbouring numbers are neighbouring cells for the most part.
std::uint8_t cell_of(const Vec3& direction) {
  const Vec3 size(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
  const double per_whole = 4 / (size.x + size.y + size.z);
  const auto quarter = [&](double part) { return std::min(static_cast<unsigned>(part * per_whole), 3U); };
  const unsigned octant = (direction.x < 0 ? 1U : 0U) | (direction.y < 0 ? 2U : 0U) | (direction.z < 0 ? 4U : 0U);
  const unsigned row = quarter(size.x), column = quarter(size.y);
  return static_cast<std::uint8_t>(octant << 4 | row << 2 | ((row & 1) != 0 ? 3 - column : column));
}

}  // namespace

std::span<const std::uint32_t> DirectionOrder::of(std::span<const Ray> rays) {
  cells_.resize(rays.size());
  order_.resize(rays.size());
  std::array<std::uint32_t, kCells + 1> first{};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    cells_[i] = cell_of(rays[i].direction);
    ++first[cells_[i] + 1U];
  }
  for (std::size_t cell = 0; cell < kCells; ++cell) first[cell + 1] += first[cell];
  for (std::size_t i = 0; i < rays.size(); ++i) order_[first[cells_[i]]++] = static_cast<std::uint32_t>(i);
  return order_;
}

}  // namespace isl::render
