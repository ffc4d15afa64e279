// An upper bound of the rounding of all faces of a shape, known when the scene is compiled. face.h gives the rounding
// of the one face that a ray meets.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

inline constexpr double kRounding = 0x1p-47;
/// The smallest sine of the angle between a ray and a surface by which a rounding is divided. At smaller angles the
/// bend of a surface, and not its slope, decides how well the crossing is known.
inline constexpr double kGrazing = 0x1p-24;
/// The rounding of t at a crossing is at most this times Spread::at(): the rounding of the face over the smallest
/// slope.
inline constexpr double kNear = kRounding / kGrazing;

/// No face of a shape is rounded by more than kRounding · at(r), where r is the largest coordinate of a point's reach.
struct Spread {
  double factor = 1, size = 0;

  [[nodiscard]] double at(double reach) const { return factor * reach + size; }
};

/// The spread of a shape whose numbers have this size.
[[nodiscard]] Spread spread_of_shape(double size);
/// The spread of the same shape as the space around it sees it.
[[nodiscard]] Spread spread_through(const scene::Transform& outer_from_inner, const Spread& inner);

/// No vector is stretched by more: the root of the product of the greatest column and row sums of the linear part,
/// which its greatest singular value is at most.
[[nodiscard]] double length_stretch(const scene::Matrix& map);

}  // namespace isl::render
