// Converts many values of linear light to the whole numbers of integer files: the same numbers as with transfer.h's
// curve, in a fraction of its time. Knows nothing of pixels or files.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace isl::render {

/// Code values from 0 to `most`: ⌊display_from_linear(v)·most + ½⌋ for every v, NaN and infinities included.
///
/// The curve's power law is interpolated by cubics. Where the interpolation's error could change the code (a few values
/// in ten thousand), the curve itself is evaluated.
class DisplayCodes {
 public:
  /// Precondition: 1 ≤ most ≤ 65535.
  explicit DisplayCodes(int most);

  [[nodiscard]] std::uint32_t operator()(double linear) const {
    if (!(linear > 0)) return 0;
    if (linear >= kFirst && linear < 1) {
      const double position = interpolated(linear) * most_ + 0.5;
      const auto code = static_cast<std::uint32_t>(position);
      const double past = position - code;
      if (past > margin_ && past < 1 - margin_) return code;
    }
    return exact(linear);
  }

 private:
  static constexpr int kPieceBits = 5;  ///< 32 pieces an octave
  static constexpr int kOctaves = 8;
  static constexpr double kFirst = 0x1p-8;  ///< above 0.0031308, where the curve turns from a line into the power law
  static constexpr std::size_t kPieces = kOctaves << kPieceBits;

  /// The exponent and the first bits of the mantissa, which number the pieces in order.
  [[nodiscard]] static std::uint64_t piece_bits(double linear) {
    return std::bit_cast<std::uint64_t>(linear) >> (52 - kPieceBits);
  }

  struct Cubic {
    double begin;             ///< start of the piece
    std::array<double, 4> c;  ///< Σ cᵢ (v − begin)ⁱ
  };

  [[nodiscard]] double interpolated(double linear) const {
    const Cubic& piece = pieces_[piece_bits(linear) - piece_bits(kFirst)];
    const double t = linear - piece.begin;
    return piece.c[0] + t * (piece.c[1] + t * (piece.c[2] + t * piece.c[3]));
  }
  [[nodiscard]] std::uint32_t exact(double linear) const;

  double most_;
  double margin_;  ///< in codes: closer than this to the border between two codes, the interpolation does not decide
  std::array<Cubic, kPieces> pieces_;
};

}  // namespace isl::render
