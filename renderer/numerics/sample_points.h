// Points for integrals over the unit square: Sobol's sequence in two dimensions, scrambled by Owen's method with
// hashes, so that every pixel and every integral has points of its own, each of which depends on its number alone. In
// any 2^m successive points that begin at a multiple of 2^m, every rectangle of area 2^-m that comes from halving the
// sides holds exactly one.
//
// A sample may have two such points, one in its pixel and one on the lens. They are the first two and the last two
// coordinates of one point of a sequence in four dimensions, so that both are evenly spread together as well. Sobol's
// third and fourth coordinates are not even by themselves: of 2^m points, 8 lie in every rectangle that comes from
// halving the sides and has an area of 8·2^-m. Therefore the second pair is the first pair of another number
// (`partner`), whose points are as even as the first, and together 2 of 16 points, 4 of up to 128 and 8 of up to 8,192
// lie in every box of the four-dimensional cube that comes from halving its sides and has a volume in proportion.
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

/// The position of a number in a shuffled order, in which any 2^m successive numbers that begin at a multiple of 2^m
/// are some that did so before. Number 0 stays the first, so that small numbers stay small.
[[nodiscard]] constexpr std::uint32_t shuffled(std::uint32_t number, std::uint32_t seed) {
  return reversed_bits(scrambled_reversed(reversed_bits(number), seed) ^ scrambled_reversed(0, seed));
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

/// By bit: what the bit adds, modulo 2, to a number's partner. The highest bit of an entry is the bit that it belongs
/// to, so that the partners of 2^m successive numbers are 2^m successive numbers, too, and their points are as even.
/// The entries were found by search, the first one first: of all numbers of that length (from 2^11 on, of 1,500 at
/// random) the one that makes the points of 2^m numbers most even in four dimensions and, among equals, in two and
/// three of them.
inline constexpr std::array<std::uint32_t, 16> kPartnerOfBit{
    0x1, 0x2, 0x5, 0xb, 0x12, 0x3f, 0x67, 0x9e, 0x1a5, 0x225, 0x6ce, 0x801, 0x11ec, 0x33f3, 0x76cb, 0xcf29};
[[nodiscard]] constexpr std::uint32_t partner_of_bit(std::uint32_t bit) {
  return bit < kPartnerOfBit.size() ? kPartnerOfBit[bit] : 1U << bit;
}
/// The number whose first pair of coordinates is this number's second pair.
[[nodiscard]] constexpr std::uint32_t partner(std::uint32_t number) {
  std::uint32_t sum = 0;
  for (std::uint32_t bit = 0; bit < 32; ++bit) sum ^= (0U - (number >> bit & 1U)) & partner_of_bit(bit);
  return sum;
}

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
    const std::uint32_t position = detail::shuffled(number, order);
    const std::uint32_t u = pair == SobolPair::first ? position : detail::partner(position);
    return {detail::in_square(u, seed_of_u()), detail::in_square(detail::reversed_second_sobol(u), seed_of_v())};
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
