// The supports of a blob's plain points as balls of single floats: quick to fetch and quick to compare, in order to
// tell which fields of a list are far from some rays before any is laid out.
#pragma once

#include "renderer/scene/transform.h"

#include <cstddef>
#include <vector>

namespace isl::render {

struct ComponentTable;

/// In the unit of SupportBalls.
struct SupportBall {
  float x, y, z, radius;
};

/// Coordinates count from `middle`, in a unit in which all balls lie in the cube from −1 to 1: there no square is too
/// large or too small for a float.
struct SupportBalls {
  scene::Vec3 middle{0};
  double per_unit = 0;             ///< 1 / unit
  std::vector<SupportBall> balls;  ///< by the component's number

  [[nodiscard]] std::size_t bytes() const { return balls.capacity() * sizeof(SupportBall); }
};

/// The balls of components 0 … plain_points − 1, each rounded to the nearest floats.
[[nodiscard]] SupportBalls support_balls(const ComponentTable& table);

}  // namespace isl::render
