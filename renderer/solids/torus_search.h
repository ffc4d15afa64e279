// How near the root of a torus's quartic has to be before Newton's steps on the distance go on (torus.cpp), as shares
// of the stretch that is searched.
#pragma once

namespace isl::render {

struct TorusSearch {
  /// Rounding of the coefficients moves a root that Newton's steps can tell from its neighbours by less than this.
  static constexpr double kMoved = 0x1p-20;
  /// A root is near enough where the next step on the quartic would be of the order of the square of this.
  static constexpr double kNear = 0x1p-22;
  /// After a step on the distance as short as this, what is left is of the size of its square.
  static constexpr double kConverged = 0x1p-40;
  static constexpr int kMostSteps = 3;
};

}  // namespace isl::render
