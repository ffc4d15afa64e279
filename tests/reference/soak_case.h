// The random blobs of the long proofs (soak.cpp). Each has a seed of its own, so that one that was once wrong can be
// looked at again, and stay as a test.
#pragma once

#include "renderer/trace/tracer.h"
#include "tests/reference/random_scenes.h"

#include <cstdint>
#include <vector>

namespace isl::reference {

/// Of 1 to 200 components, of any scale from 10⁻³ to 10³ and hardness up to 300.
[[nodiscard]] RandomBlobOptions varied_options(RandomSource& random);

struct SoakCase {
  scene::Database database;
  double scale;  ///< everything lies within about this radius
  render::Tolerance tolerance;
  std::vector<render::Ray> rays;  ///< from outside and, some, from within
};

[[nodiscard]] SoakCase soak_case(RandomSource& random);

/// Another blob of those, and lines through it.
struct LinesThroughBlob {
  scene::Database database;
  std::vector<LineOfSight> lines;
  double hardest;  ///< hardness of the hardest kernels
};
[[nodiscard]] LinesThroughBlob lines_through_blob(RandomSource& random, int lines);

}  // namespace isl::reference
