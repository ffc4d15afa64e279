// Points for integrals over the unit square: Sobol's sequence in two dimensions, scrambled by Owen's method with
// hashes, so that every pixel and every integral has points of its own, each of which depends on its number alone. In
// any 2^m successive points that begin at a multiple of 2^m, every rectangle of area 2^-m that comes from halving the
// sides holds exactly one.
//
// A sample may have two such points, one in its pixel and one on the lens. They are the first two and the last two
// coordinates of one point of a sequence in four dimensions, so that both are evenly spread together as well: of the
// same 2^m points, 8 lie in every box of the four-dimensional cube that comes from halving its sides and has a volume
// of 8·2^-m.
//
// Shuffling the order and scrambling the digits by hashes: Burley, Practical Hash-based Owen Scrambling, 2020. The hash
// is that of Laine and Karras (2011), with the constants that Vegdahl found in 2021.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isl::render {

/// Both coordinates are in [0, 1).
struct UnitPoint {
  double u = 0, v = 0;
};

namespace detail {

/// In this order, because GCC makes the order of bytes one instruction, which old machines lack for vectors, if both of
/// its steps come together.
[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t bits) {
  bits = (bits >> 8 & 0x00FF00FFU) | (bits & 0x00FF00FFU) << 8;
  bits = (bits >> 1 & 0x55555555U) | (bits & 0x55555555U) << 1;
  bits = (bits >> 2 & 0x33333333U) | (bits & 0x33333333U) << 2;
  bits = (bits >> 4 & 0x0F0F0F0FU) | (bits & 0x0F0F0F0FU) << 4;
  return bits >> 16 | bits << 16;
}

/// Owen's scrambling of a number whose bits are reversed: each bit of the result depends on itself and on lower ones.
[[nodiscard]] constexpr std::uint32_t scrambled_reversed(std::uint32_t bits, std::uint32_t seed) {
  bits ^= bits * 0x3d20adeaU;
  bits += seed;
  bits *= (seed >> 16) | 1U;
  bits ^= bits * 0x05526c56U;
  bits ^= bits * 0x53a22864U;
  return bits;
}

[[nodiscard]] constexpr std::uint32_t scrambled(std::uint32_t bits, std::uint32_t seed) {
  return reversed_bits(scrambled_reversed(reversed_bits(bits), seed));
}

/// A coordinate of Sobol's sequence, given with its bits reversed, after scrambling.
[[nodiscard]] constexpr std::uint32_t in_square(std::uint32_t reversed, std::uint32_t seed) {
  return reversed_bits(scrambled_reversed(reversed, seed));
}

/// Sobol's second coordinate, with its bits reversed: the number's bits multiplied by Pascal's triangle modulo 2. An
/// entry (j over i) of that is odd if i has all the bits of j (Lucas), so that each step adds the bits whose places
/// have one more of these.
[[nodiscard]] constexpr std::uint32_t reversed_second_sobol(std::uint32_t number) {
  number ^= number >> 1 & 0x55555555U;
  number ^= number >> 2 & 0x33333333U;
  number ^= number >> 4 & 0x0F0F0F0FU;
  number ^= number >> 8 & 0x00FF00FFU;
  return number ^ (number >> 16 & 0x0000FFFFU);
}

/// Sobol's third or fourth coordinate, with its bits reversed: the sum of the direction numbers of a number's bits, by
/// bytes.
class LaterSobol {
 public:
  /// `degree` of the coordinate's polynomial over the numbers 0 and 1, `taps`: bit k - 1 is the coefficient of
  /// x^(degree - k) for 0 < k < degree, and the first direction numbers times 2^1, 2^2, 2^3 … (Joe and Kuo 2008).
  constexpr LaterSobol(int degree, std::uint32_t taps, const std::array<std::uint32_t, 3>& first) {
    std::array<std::uint32_t, 32> directions{};
    for (int i = 0; i < 32; ++i) {
      std::uint32_t& direction = directions[static_cast<std::size_t>(i)];
      const auto before = [&](int k) { return directions[static_cast<std::size_t>(i - k)]; };
      if (i < degree) {
        direction = first[static_cast<std::size_t>(i)] << (31 - i);
        continue;
      }
      direction = before(degree) ^ before(degree) >> degree;
      for (int k = 1; k < degree; ++k) direction ^= (taps >> (k - 1) & 1) != 0 ? before(k) : 0;
    }
    for (std::size_t byte = 0; byte < sums_.size(); ++byte) {
      for (std::size_t value = 0; value < 256; ++value) {
        for (std::size_t bit = 0; bit < 8; ++bit) {
          if ((value >> bit & 1) != 0) sums_[byte][value] ^= reversed_bits(directions[8 * byte + bit]);
        }
      }
    }
  }
  [[nodiscard]] constexpr std::uint32_t operator[](std::uint32_t number) const {
    return sums_[0][number & 255] ^ sums_[1][number >> 8 & 255] ^ sums_[2][number >> 16 & 255] ^ sums_[3][number >> 24];
  }

 private:
  std::array<std::array<std::uint32_t, 256>, 4> sums_{};
};
inline constexpr LaterSobol kThirdSobol(2, 1, {1, 3});      // x² + x + 1
inline constexpr LaterSobol kFourthSobol(3, 2, {1, 3, 1});  // x³ + x + 1

}  // namespace detail

/// A seed for one of several uses of the same seed. A change of any bit changes each bit of the result with a
/// probability close to one half (the finalizer of MurmurHash3).
[[nodiscard]] constexpr std::uint32_t derived_seed(std::uint32_t seed, std::uint32_t use) {
  std::uint32_t bits = seed ^ (use * 0x9e3779b9U + 0x7f4a7c15U);
  bits = (bits ^ (bits >> 16)) * 0x85ebca6bU;
  bits = (bits ^ (bits >> 13)) * 0xc2b2ae35U;
  return bits ^ (bits >> 16);
}

/// Two of the coordinates of Sobol's sequence.
enum class SobolPair : std::uint8_t { first, second };

/// A point of the unit square by its coordinates in units of 2⁻³².
struct SquarePlace {
  std::uint32_t u = 0, v = 0;

  [[nodiscard]] constexpr UnitPoint point() const { return {u * 0x1p-32, v * 0x1p-32}; }
};

/// A sequence of points.
struct PointSequence {
  std::uint32_t order;  ///< sequences that are to be even together have this in common
  std::uint32_t seed;   ///< and not this
  SobolPair pair = SobolPair::first;

  [[nodiscard]] constexpr UnitPoint operator[](std::uint32_t number) const { return place(number).point(); }
  [[nodiscard]] constexpr SquarePlace place(std::uint32_t number) const {
    const std::uint32_t place = detail::scrambled(number, order);
    const bool is_first = pair == SobolPair::first;
    const std::uint32_t u = is_first ? place : detail::kThirdSobol[place];
    const std::uint32_t v = is_first ? detail::reversed_second_sobol(place) : detail::kFourthSobol[place];
    return {detail::in_square(u, seed_of_u()), detail::in_square(v, seed_of_v())};
  }
  /// Seeds by which the coordinates are scrambled.
  [[nodiscard]] constexpr std::uint32_t seed_of_u() const { return derived_seed(seed, 1); }
  [[nodiscard]] constexpr std::uint32_t seed_of_v() const { return derived_seed(seed, 2); }
};

/// The point of this number in the sequence of a seed.
[[nodiscard]] constexpr UnitPoint sample_point(std::uint32_t seed, std::uint32_t number) {
  return PointSequence{seed, seed}[number];
}

}  // namespace isl::render
