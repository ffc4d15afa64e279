// Blobs in which a small component stands beside something 10⁶ to 10¹⁵ times as large, with rays that meet the small
// one.
#pragma once

#include "tests/reference/random_scenes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isl::reference {

/// A kernel and a skeleton that go together.
struct Combination {
  scene::Kernel kernel;
  scene::Skeleton skeleton;

  [[nodiscard]] std::string name() const;
};

/// These kernels with every skeleton; in every mode that the two have.
[[nodiscard]] std::vector<Combination> combinations_of(const std::vector<scene::Kernel>& kernels);
/// Every kernel, soft and hard.
[[nodiscard]] std::vector<Combination> every_combination();

enum class Extreme : std::uint8_t {
  far,        ///< a ball far away
  huge,       ///< a ball whose surface passes through the small component
  stretched,  ///< the component itself, stretched along x and flattened along z
};
inline constexpr const char* kExtremeNames[] = {"far", "huge", "stretched"};

struct ScaleCase {
  scene::Database database;
  std::vector<LineOfSight> lines;
  double pixel_angle;  ///< a fiftieth of the detail
};

/// The detail over the extent is 10^−exponent.
[[nodiscard]] ScaleCase scale_case(RandomSource& random, const Combination& combination, Extreme extreme, int exponent,
                                   int lines);

/// A case with everything about it drawn from one seed, the exponent from 6 to 15.
struct SeededScaleCase {
  Combination combination;
  Extreme extreme;
  int exponent;
  ScaleCase made;
};
[[nodiscard]] SeededScaleCase seeded_scale_case(std::uint64_t seed, int lines);

/// A component, and a ball that takes away from it: their surface is where the two differ by the threshold, far within
/// both, where their fields are worth 10 to 10⁶. A relative error of either field moves the surface, although the same
/// error where the field is worth 1 would hardly move it.
[[nodiscard]] ScaleCase opposed_case(RandomSource& random, const Combination& combination, int lines);

}  // namespace isl::reference
