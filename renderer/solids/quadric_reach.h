// How far a quadric reaches: what boxes of ellipsoids follow from.
#pragma once

#include "renderer/scene/transform.h"

#include <vector>

namespace isl::render {

/// The greatest direction · p over the points with pᵀAp + b·p + c ≤ 0; infinite for any other quadric than an
/// ellipsoid. Coefficients in the order of scene::Polynomial.
[[nodiscard]] double ellipsoid_reach(const std::vector<double>& coefficients, const scene::Vec3& direction);

}  // namespace isl::render
