// Where an image lies in space: from a point to a place on the image, by its map type and repetition, and from there to
// the texels that are mixed, by its interpolation. The formulas are POV-Ray's, as measured. Colours are unknown here.
#pragma once

#include "renderer/scene/image.h"
#include "renderer/scene/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace isl::render {

/// A place on an image in texels: x from the left border, y from the lower one; either may be outside.
struct TexelPlace {
  double x, y;
};

/// One of the texels that a value is the weighted mean of; they are numbered row by row from the top.
struct TexelTap {
  std::size_t texel;
  double weight;
};
struct TexelTaps {
  std::array<TexelTap, 16> taps;  ///< the first `count` are set
  int count = 0;
  void add(std::size_t texel, double weight) noexcept { taps[static_cast<std::size_t>(count++)] = {texel, weight}; }
};

class ImagePlacing {
 public:
  ImagePlacing(const scene::Image& image, int width, int height)
      : map_type_(image.map_type),
        interpolate_(image.interpolate),
        once_(image.once),
        repeat_x_(image.repeat_x),
        repeat_y_(image.repeat_y),
        offset_x_(image.offset_x),
        offset_y_(image.offset_y),
        width_(width),
        height_(height) {}

  /// Nullopt outside an image that is mapped once.
  [[nodiscard]] std::optional<TexelPlace> place_of(const scene::Vec3& p) const noexcept;
  /// The place some texels away. It is on the other side of the image if that is beyond a border.
  [[nodiscard]] TexelPlace neighbour(const TexelPlace& place, double dx, double dy) const noexcept;
  /// True if values are means of several texels.
  [[nodiscard]] bool mixes_texels() const noexcept { return interpolate_ >= 2; }
  [[nodiscard]] TexelTaps taps_of(const TexelPlace& place) const noexcept;
  /// The texel that a place lies on: the only one of taps_of() if no texels are mixed.
  [[nodiscard]] std::size_t texel_at(const TexelPlace& place) const noexcept { return texel_number(place.x, place.y); }

 private:
  /// The number of the texel at a place along a side of so many texels, as often as they repeat; 0 for NaN and places
  /// that have no whole number.
  [[nodiscard]] static std::size_t wrapped(double place, int size) noexcept {
    // Most places are near the origin, and a division of short numbers takes half as long.
    if (std::abs(place) < 0x1p30) [[likely]]
      return whole_of<std::int32_t>(place, size);
    return std::abs(place) < 0x1p62 ? whole_of<std::int64_t>(place, size) : 0;
  }
  template <class Integer>
  [[nodiscard]] static std::size_t whole_of(double place, Integer size) noexcept {
    auto texel = static_cast<Integer>(place);
    if (static_cast<double>(texel) > place) --texel;
    if (texel >= 0 && texel < size) return static_cast<std::size_t>(texel);
    const Integer rest = texel % size;
    return static_cast<std::size_t>(rest < 0 ? rest + size : rest);
  }
  /// The same for an image that is mapped once.
  [[nodiscard]] static std::size_t clamped(double place, int size) noexcept {
    return place > 0 ? static_cast<std::size_t>(std::min(place, size - 1.0)) : 0;
  }
  /// The number of a column, and that of the first texel of a row from below; either may be outside.
  [[nodiscard]] std::size_t column_number(double column) const noexcept {
    return once_ ? clamped(column, width_) : wrapped(column, width_);
  }
  [[nodiscard]] std::size_t row_start(double row) const noexcept {
    const std::size_t from_below = once_ ? clamped(row, height_) : wrapped(row, height_);
    return (static_cast<std::size_t>(height_ - 1) - from_below) * static_cast<std::size_t>(width_);
  }
  [[nodiscard]] std::size_t texel_number(double column, double row) const noexcept {
    return row_start(row) + column_number(column);
  }

  int map_type_, interpolate_;
  bool once_;
  double repeat_x_, repeat_y_, offset_x_, offset_y_;
  int width_, height_;
};

}  // namespace isl::render
