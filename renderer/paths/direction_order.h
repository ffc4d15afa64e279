// Brings rays of like directions together. Rays that leave a surface to all sides meet different objects one by one,
// but among a thousand of them eight have nearly the same direction, and start close to one another.
#pragma once

#include "renderer/rays/ray.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

/// Its memory is kept from call to call.
class DirectionOrder {
 public:
  /// The numbers of the rays, by direction; those of one cell of directions stay in their order. Valid until the next
  /// call.
  [[nodiscard]] std::span<const std::uint32_t> of(std::span<const Ray> rays);

 private:
  std::vector<std::uint8_t> cells_;  ///< of the rays
  std::vector<std::uint32_t> order_;
};

}  // namespace isl::render
