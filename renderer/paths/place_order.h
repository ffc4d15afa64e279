// Brings neighbouring points of the unit square together. Rays to an area light from the samples of a few pixels go to
// points all over it; those to one part of it meet the same things on their way.
#pragma once

#include "renderer/numerics/sample_points.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace isl::render {

/// Its memory is kept from call to call.
class PlaceOrder {
 public:
  /// The numbers of the points, by the part of the square that they are in; those of one part stay in their order.
  /// Valid until the next call, as unsorted() is.
  [[nodiscard]] std::span<const std::uint32_t> of(std::span<const UnitPoint> points) {
    order_.resize(points.size());
    parts_.resize(points.size());
    std::array<std::uint32_t, kParts + 1> first{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      parts_[i] = part_of(points[i]);
      ++first[parts_[i] + 1U];
    }
    for (std::size_t part = 0; part < kParts; ++part) first[part + 1] += first[part];
    for (std::size_t i = 0; i < points.size(); ++i) order_[first[parts_[i]]++] = static_cast<std::uint32_t>(i);
    return order_;
  }
  /// The numbers of the points in their order.
  [[nodiscard]] std::span<const std::uint32_t> unsorted(std::span<const UnitPoint> points) {
    order_.resize(points.size());
    std::iota(order_.begin(), order_.end(), 0U);
    return order_;
  }

 private:
  static constexpr unsigned kSide = 4;
  static constexpr std::size_t kParts = std::size_t{kSide} * kSide;

  /// Row by row, to and fro, so that parts with neighbouring numbers are neighbours.
  [[nodiscard]] static std::uint8_t part_of(const UnitPoint& point) {
    const auto along = [](double place) { return std::min(static_cast<unsigned>(place * kSide), kSide - 1); };
    const unsigned row = along(point.u), column = along(point.v);
    return static_cast<std::uint8_t>(row * kSide + ((row & 1) != 0 ? kSide - 1 - column : column));
  }

  std::vector<std::uint8_t> parts_;  ///< of the points
  std::vector<std::uint32_t> order_;
};

}  // namespace isl::render
