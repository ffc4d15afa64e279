// Sines and cosines of the angles at which rows and columns of a picture are seen.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isl::render {

/// The sine and the cosine of an angle.
struct SineCosine {
  double sine = 0, cosine = 1;
};

/// Remembers the sines and cosines of the last angles that it was asked for. Neighbouring rays share the angle of their
/// row or their column; what it answers does not depend on what it remembers.
class RecurringAngles {
 public:
  /// The sine and the cosine of an angle in radians.
  [[nodiscard]] SineCosine operator()(double angle) {
    const auto bits = std::bit_cast<std::uint64_t>(angle);
    Remembered& remembered = remembered_[slot(bits)];
    if (remembered.angle != bits) remembered = {bits, {std::sin(angle), std::cos(angle)}};
    return remembered.ratios;
  }

 private:
  struct Remembered {
    std::uint64_t angle = 0;  ///< the bits of its double
    SineCosine ratios;
  };

  /// Four times as many as a tile (tiles.h) has rows and columns, so that few of them share a slot.
  static constexpr int kLog2Slots = 8;
  /// The golden ratio's fraction spreads numbers in a row evenly (Knuth, The Art of Computer Programming 3, 6.4).
  [[nodiscard]] static std::size_t slot(std::uint64_t bits) { return bits * 0x9E3779B97F4A7C15 >> (64 - kLog2Slots); }

  std::array<Remembered, std::size_t{1} << kLog2Slots> remembered_{};
};

}  // namespace isl::render
