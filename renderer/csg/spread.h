// An upper bound of the rounding of all faces of a shape, known when the scene is compiled. face.h gives the rounding
// of the one face that a ray meets.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

inline constexpr double kRounding = 0x1p-47;
/// Where a ray meets a surface under a smaller angle, no surface that bends is known any better: quotients end here.
inline constexpr double kGrazing = 0x1p-24;
/// Crossings of two faces that lie within their rounding are no farther apart than this times Spread::at().
inline constexpr double kNear = kRounding / kGrazing;

/// No face of a shape is rounded by more than kRounding times at(the largest coordinate of a point's
/// reach).
struct Spread {
  double factor = 1, size = 0;

  [[nodiscard]] double at(double reach) const { return factor * reach + size; }
};

/// The spread of a shape whose numbers are of that size.
[[nodiscard]] Spread spread_of_shape(double size);
/// The same shape's around its place.
[[nodiscard]] Spread spread_through(const scene::Transform& outer_from_inner, const Spread& inner);

/// The Frobenius norm of the linear part: no vector is stretched by more.
[[nodiscard]] double frobenius_norm(const scene::Matrix& map);

}  // namespace isl::render
