#include "renderer/patterns/kinds/random_cubes.h"

#include "renderer/values/integer.h"

#include <cmath>
#include <random>

namespace isl::render {

Cube cube_of(const scene::Vec3& p) noexcept {
  return {values::to_integer(std::floor(p.x)), values::to_integer(std::floor(p.y)),
          values::to_integer(std::floor(p.z))};
}

RandomCubes::RandomCubes() noexcept : hashes_(values::noise_tables().hash) {
  std::mt19937 generator;
  for (double& number : numbers_) number = static_cast<double>(generator()) * 0x1p-32;
}

const RandomCubes& random_cubes() noexcept {
  static const RandomCubes kCubes;
  return kCubes;
}

}  // namespace isl::render
