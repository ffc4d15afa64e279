// A rank-1 lattice of N points: (i, g i mod N)/N, wrapped so that i = 0 is the centre. With g coprime to N every row
// and every column of the N × N raster holds one point, which serves edges near the axes; among those g, the lattice
// whose nearest points are farthest apart is the most even one (Dammertz and Keller, Image Synthesis by Rank-1
// Lattices). The shortest vector of the lattice spanned by (1, g) and (0, N) comes from Gauss' reduction in O(log N).
#include "renderer/film/sample_pattern.h"

#include "base/check.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace isl::render {
namespace {

struct LatticeVector {
  std::int64_t x, y;
  [[nodiscard]] std::int64_t dot(const LatticeVector& other) const { return x * other.x + y * other.y; }
};

std::int64_t shortest_squared(std::int64_t generator, std::int64_t count) {
  LatticeVector a{1, generator};
  LatticeVector b{0, count};
  while (true) {
    const std::int64_t whole = std::llround(static_cast<double>(a.dot(b)) / static_cast<double>(a.dot(a)));
    b = {b.x - whole * a.x, b.y - whole * a.y};
    if (b.dot(b) >= a.dot(a)) return a.dot(a);
    std::swap(a, b);
  }
}

std::int64_t best_generator(std::int64_t count) {
  std::int64_t best = 1;
  std::int64_t best_distance = 0;
  for (std::int64_t generator = 1; generator <= count / 2; ++generator) {
    if (std::gcd(generator, count) != 1) continue;
    const std::int64_t distance = shortest_squared(generator, count);
    if (distance > best_distance) best = generator, best_distance = distance;
  }
  return best;
}

}  // namespace

std::vector<SampleOffset> sample_pattern(int count) {
  ISL_CHECK(count >= 1, "{} samples", count);
  const std::int64_t n = count;
  const std::int64_t generator = best_generator(n);
  const auto wrapped = [n](std::int64_t numerator) {
    return static_cast<double>(2 * numerator >= n ? numerator - n : numerator) / static_cast<double>(n);
  };
  std::vector<SampleOffset> offsets;
  offsets.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < n; ++i) offsets.push_back({wrapped(i), wrapped(i * generator % n)});
  return offsets;
}

}  // namespace isl::render
