// Seeded random numbers, rays and blobs for tests. They are the same on every machine, because the mapping from the
// generator's bits is our own (the standard's distributions differ between libraries).
#pragma once

#include "renderer/scene/database.h"

#include <cstdint>
#include <random>
#include <vector>

namespace isl::reference {

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : bits_(seed) {}

  /// A number in [0, 1), a multiple of 2^-53.
  [[nodiscard]] double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
  /// A number in [0, count).
  [[nodiscard]] int below(int count) { return static_cast<int>(unit() * count); }
  /// A vector of unit length, uniform on the sphere.
  [[nodiscard]] scene::Vec3 direction();
  /// A point, uniform in the ball of this radius about the origin.
  [[nodiscard]] scene::Vec3 in_ball(double radius);

 private:
  std::mt19937_64 bits_;
};

struct LineOfSight {
  scene::Vec3 origin, direction;  ///< direction has unit length
};

/// A line from the sphere of radius `distance` about the origin towards a point of the ball of radius `target`.
[[nodiscard]] LineOfSight random_line(RandomSource& random, double distance, double target);

/// Lines as pictures have them: groups of eight from one place, some closer together than others, and every third as
/// far apart as possible.
[[nodiscard]] std::vector<LineOfSight> random_lines(RandomSource& random, int count, double distance, double target);

/// A rotation, uneven scaling in [½, 2] (mirrored in one of four) and a shift of at most `shift`.
[[nodiscard]] scene::Transform random_transform(RandomSource& random, double shift);

struct RandomBlobOptions {
  int components = 20;
  double scale = 1;           ///< everything lies within about this radius
  bool negatives = true;      ///< one component in four carves
  bool transforms = true;     ///< one component in three has its own
  bool maxima = false;        ///< components lie in branches of two maxima, one of them with another inside
  bool half_space = false;    ///< one more component, whose plane passes within the scale
  bool convolutions = false;  ///< two in three of the segments and circles, and every other plane, are convolved
  double hardest =
      8;  ///< hardness of the hardest kernels; with hardness h, gaussian and cauchy have about e^h in the middle
};

/// One blob of all skeletons with all kernels and both meanings of the radius, placed once in the world.
[[nodiscard]] scene::Database random_blob(RandomSource& random, const RandomBlobOptions& options);

}  // namespace isl::reference
