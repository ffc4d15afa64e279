// The internal functions that are geometry; see internal_functions.h.
#pragma once

namespace isl::values {

// p[0], p[1], p[2] is the point; the parameters follow from p[3] on, in the order of POV-Ray's manual.

/// The point's distance from the origin, its angle about y (from +z towards +x), and its angle from +y.
[[nodiscard]] double radius(const double* p);
[[nodiscard]] double azimuth(const double* p);
[[nodiscard]] double polar_angle(const double* p);

[[nodiscard]] double sphere(const double* p);
[[nodiscard]] double ellipsoid(const double* p);
[[nodiscard]] double torus(const double* p);
[[nodiscard]] double rounded_box(const double* p);
[[nodiscard]] double superellipsoid(const double* p);

/// Coils about y: helix_1 stacks flat rings that climb, helix_2 pushes a circle upwards as it runs round.
/// Cross-sections range from a square (0) over a circle (1) to a diamond (2) and beyond.
[[nodiscard]] double helix_1(const double* p);
[[nodiscard]] double helix_2(const double* p);

}  // namespace isl::values
