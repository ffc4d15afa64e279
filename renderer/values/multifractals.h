// Sums of noise whose roughness varies with height, after Musgrave ("Texturing and Modeling", chapter on
// multifractals): internal functions, see internal_functions.h. Details are POV-Ray's, as measured.
#pragma once

namespace isl::values {

// p[0], p[1], p[2] is the point; H (p[3]), lacunarity (p[4]), octaves (p[5]), offset (p[6]) follow.

/// Higher terrain is rougher: each octave is weighted with the height so far, to the power of T (p[7], truncated to an
/// integer; no weight below 1). p[8] is the noise generator. A fraction of an octave counts by its part, always
/// weighted.
[[nodiscard]] double heterogeneous_multifractal(const double* p);

/// Ridges stand where noise crosses its middle; gain (p[7]) sharpens them. p[8] is the noise generator. A fraction of
/// an octave counts in full.
[[nodiscard]] double ridged_multifractal(const double* p);

}  // namespace isl::values
