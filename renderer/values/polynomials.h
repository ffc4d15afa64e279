// The internal functions that are polynomials in x, y, z, times a field strength; see internal_functions.h. Most are
// surfaces named after a mathematician or a shape. Their value is clipped to ±10, as in POV-Ray, which does so for its
// root finding.
#pragma once

namespace isl::values {

// p[0], p[1], p[2] is the point, p[3] the field strength, further parameters follow.
[[nodiscard]] double crossed_trough(const double* p);
[[nodiscard]] double cubic_saddle(const double* p);
[[nodiscard]] double cushion(const double* p);  ///< also f_odd
[[nodiscard]] double devils_curve(const double* p);
[[nodiscard]] double glob(const double* p);
[[nodiscard]] double heart(const double* p);
[[nodiscard]] double hunt_surface(const double* p);
[[nodiscard]] double klein_bottle(const double* p);
[[nodiscard]] double kummer_surface_1(const double* p);
[[nodiscard]] double lemniscate_of_gerono(const double* p);
[[nodiscard]] double mitre(const double* p);
[[nodiscard]] double nodal_cubic(const double* p);
[[nodiscard]] double paraboloid(const double* p);
[[nodiscard]] double pillow(const double* p);
[[nodiscard]] double piriform(const double* p);
[[nodiscard]] double quartic_paraboloid(const double* p);
[[nodiscard]] double quartic_saddle(const double* p);
[[nodiscard]] double steiners_roman(const double* p);
[[nodiscard]] double torus_gumdrop(const double* p);
[[nodiscard]] double umbrella(const double* p);

}  // namespace isl::values
