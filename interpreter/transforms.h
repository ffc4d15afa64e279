// Affine maps as scenes write them, with their inverses. Angles in this interface are in degrees.
#pragma once

#include "renderer/scene/transform.h"

#include <numbers>

namespace isl::interpreter {

[[nodiscard]] constexpr double radians_from_degrees(double degrees) { return degrees * (std::numbers::pi / 180); }

[[nodiscard]] scene::Transform translation(const scene::Vec3& offset);
/// Rotation about x, then y, then z, by `degrees` each; with POV-Ray's signs (90° about y takes z to x).
[[nodiscard]] scene::Transform rotation(const scene::Vec3& degrees);
/// Precondition: no factor is zero.
[[nodiscard]] scene::Transform scaling(const scene::Vec3& factors);
/// v after rotation(degrees).
[[nodiscard]] scene::Vec3 rotated(const scene::Vec3& v, const scene::Vec3& degrees);

/// The inverse of an affine matrix; false if it is singular. `condition` is an estimate of the condition number of the
/// linear part (in the Frobenius norm).
[[nodiscard]] bool invert(const scene::Matrix& matrix, scene::Matrix& inverse, double& condition);

/// The condition number of a map's linear part, by its stored inverse, in the Frobenius norm.
[[nodiscard]] double condition_of(const scene::Transform& transform);

/// The relative error of a place that is mapped and mapped back: the greatest entry of M·M⁻¹ − I, of the linear parts.
/// It is far below the condition number times a rounding for scalings, which are exact along each axis.
[[nodiscard]] double inverse_error(const scene::Transform& transform);

/// The factor by which a similarity (rotations, reflections, one scale) scales lengths; 0 for every other map.
[[nodiscard]] double similarity_factor(const scene::Matrix& matrix);

}  // namespace isl::interpreter
