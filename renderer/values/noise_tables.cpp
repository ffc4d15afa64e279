#include "renderer/values/noise_tables.h"

#include <bit>
#include <cmath>
#include <utility>

namespace isl::values {
namespace {

/// The generator behind the language's rand() (interpreter/random_streams.h). Only the upper half of its state is used,
/// without the sign.
class Generator {
 public:
  explicit Generator(std::uint32_t seed) : state_(seed) {}
  std::uint32_t next() {
    state_ = state_ * 1812433253u + 12345u;
    return state_ >> 16 & 0x7FFFu;
  }

 private:
  std::uint32_t state_;
};

/// Adds one byte to a CRC-16/ARC: reflected, polynomial x¹⁶ + x¹⁵ + x² + 1, initial value 0.
std::uint32_t checksum(std::uint32_t crc, std::uint32_t byte) {
  crc ^= byte;
  for (int bit = 0; bit < 8; ++bit) crc = (crc & 1u) != 0 ? crc >> 1 ^ 0xA001u : crc >> 1;
  return crc;
}

/// Rounds to six significant digits, because tables of this noise have been published with that many.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

/// The checksum of the vector (s, s, s), s = 0.12345·i, whose doubles are written with the most significant byte first,
/// as a number in [−1, 1].
double random_term(std::size_t i) {
  constexpr double kStep = 0.12345;
  const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(i) * kStep);
  std::uint32_t crc = 0;
  for (int coordinate = 0; coordinate < 3; ++coordinate) {
    for (int shift = 56; shift >= 0; shift -= 8) crc = checksum(crc, static_cast<std::uint32_t>(bits >> shift & 0xFFu));
  }
  return rounded(crc * (2.0 / 65535.0) - 1);
}

/// Shuffles from the end: every entry is exchanged once with a random one.
void shuffle(NoiseTables& tables) {
  for (std::size_t i = 0; i < tables.hash.size(); ++i) tables.hash[i] = static_cast<std::uint16_t>(i);
  Generator generator(0);
  for (std::size_t i = tables.hash.size(); i-- > 0;)
    std::swap(tables.hash[i], tables.hash[generator.next() % NoiseTables::kHashes]);
}

/// Perlin's initialisation: directions evenly from the ball by rejection, then every second entry of the permutation is
/// exchanged with a random one. (It starts beyond the permutation, at an entry that holds 0.)
void make_gradients(NoiseTables& tables) {
  constexpr std::size_t kCount = NoiseTables::kGradients;
  Generator generator(1);
  for (std::size_t i = 0; i < kCount; ++i) {
    std::array<double, 3> v{};
    double squared = 0;
    do {
      squared = 0;
      for (double& term : v) {
        term = (static_cast<double>(generator.next() % (2 * kCount)) - kCount) / kCount;
        squared += term * term;
      }
    } while (squared > 1 || squared == 0);
    const double length = std::sqrt(squared);
    tables.gradients[i] = {v[0] / length, v[1] / length, v[2] / length};
    tables.permutation[i] = static_cast<std::uint16_t>(i);
  }
  tables.permutation[kCount] = 0;
  for (std::size_t i = kCount; i > 0; i -= 2)
    std::swap(tables.permutation[i], tables.permutation[generator.next() % kCount]);
  for (std::size_t i = 0; i < kCount + 2; ++i) {
    tables.permutation[kCount + i] = tables.permutation[i];
    tables.gradients[kCount + i] = tables.gradients[i];
  }
}

/// The terms once more, by lattice point. Halves are exact.
void arrange_slopes(NoiseTables& tables) {
  for (std::size_t i = 0; i < tables.hash.size(); ++i)
    tables.point[i] = static_cast<std::uint16_t>(tables.hash[i] % NoiseTables::kSlopes);
  for (std::size_t i = 0; i < NoiseTables::kSlopes; ++i) {
    const auto of = [&](std::size_t first) {
      const double* const terms = &tables.terms[i + first];
      return NoiseTables::Slope{terms[0] * 0.5, terms[1], terms[2], terms[3]};
    };
    const NoiseTables::Slope parts[3] = {of(0), of(4), of(8)};
    tables.slopes[i] = parts[0];
    for (std::size_t term = 0; term < 4; ++term)
      tables.vector_slopes[i][term] = {parts[0][term], parts[1][term], parts[2][term], 0};
  }
}

NoiseTables make_tables() {
  NoiseTables tables{};
  for (std::size_t i = 0; i < tables.terms.size(); ++i) tables.terms[i] = random_term(i);
  shuffle(tables);
  arrange_slopes(tables);
  make_gradients(tables);
  return tables;
}

}  // namespace

const NoiseTables& noise_tables() noexcept {
  static const NoiseTables kTables = make_tables();
  return kTables;
}

}  // namespace isl::values
