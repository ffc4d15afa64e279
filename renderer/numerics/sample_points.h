// Points for integrals over the unit square: Sobol's sequence in two dimensions, scrambled by Owen's method with
// hashes, so that every pixel and every integral has points of its own, each of which depends on its number alone. In
// any 2^m successive points that begin at a multiple of 2^m, every rectangle of area 2^-m that comes from halving the
// sides holds exactly one.
//
// Shuffling the order and scrambling the digits by hashes: Burley, Practical Hash-based Owen Scrambling, 2020. The hash
// is that of Laine and Karras (2011), with the constants that Vegdahl found in 2021.
#pragma once

#include <cstdint>

namespace isl::render {

/// Both coordinates are in [0, 1).
struct UnitPoint {
  double u = 0, v = 0;
};

namespace detail {

[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t bits) {
  bits = (bits >> 1 & 0x55555555U) | (bits & 0x55555555U) << 1;
  bits = (bits >> 2 & 0x33333333U) | (bits & 0x33333333U) << 2;
  bits = (bits >> 4 & 0x0F0F0F0FU) | (bits & 0x0F0F0F0FU) << 4;
  bits = (bits >> 8 & 0x00FF00FFU) | (bits & 0x00FF00FFU) << 8;
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

}  // namespace detail

/// A seed for one of several uses of the same seed. A change of any bit changes each bit of the result with a
/// probability close to one half (the finalizer of MurmurHash3).
[[nodiscard]] constexpr std::uint32_t derived_seed(std::uint32_t seed, std::uint32_t use) {
  std::uint32_t bits = seed ^ (use * 0x9e3779b9U + 0x7f4a7c15U);
  bits = (bits ^ (bits >> 16)) * 0x85ebca6bU;
  bits = (bits ^ (bits >> 13)) * 0xc2b2ae35U;
  return bits ^ (bits >> 16);
}

/// The point of this number in the sequence of a seed.
[[nodiscard]] constexpr UnitPoint sample_point(std::uint32_t seed, std::uint32_t number) {
  const std::uint32_t place = detail::scrambled(number, seed);
  const std::uint32_t first = detail::scrambled_reversed(place, derived_seed(seed, 1));
  const std::uint32_t second = detail::scrambled_reversed(detail::reversed_second_sobol(place), derived_seed(seed, 2));
  return {detail::reversed_bits(first) * 0x1p-32, detail::reversed_bits(second) * 0x1p-32};
}

/// The points of a seed, moved together round the edges of the square so that number 0 is in the middle.
class CentredPoints {
 public:
  constexpr explicit CentredPoints(std::uint32_t seed) : seed_(seed), first_(sample_point(seed, 0)) {}

  [[nodiscard]] constexpr UnitPoint operator[](std::uint32_t number) const {
    const UnitPoint point = sample_point(seed_, number);
    return {moved(point.u, first_.u), moved(point.v, first_.v)};
  }

 private:
  [[nodiscard]] static constexpr double moved(double value, double middle) {
    const double sum = value - middle + 0.5;
    return sum < 0 ? sum + 1 : sum >= 1 ? sum - 1 : sum;
  }

  std::uint32_t seed_;
  UnitPoint first_;
};

}  // namespace isl::render
