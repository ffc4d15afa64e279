// Checks that the reference is the truth, ray by ray, by interval arithmetic. The proof uses the ranges of fields over
// boxes, which need only that a field falls with the distance from its skeleton: no derivative, no cubic, no solver.
//
// For a root at t on a blob, it shows for the least possible δ that
//   - the field stays on one side of the threshold on the whole way from the ray's origin to t − δ, and
//   - is on that side for certain at t − δ, and on the other at t + δ;
// so the first root lies within δ of t. Other blobs are shown to stay on one side up to t. The way is bisected until
// every piece's box is decided. A ray that grazes may stay undecided, because no range decides near the point where it
// touches.
#pragma once

#include "renderer/accuracy/ray_measures.h"

#include <cstdint>
#include <span>

namespace isl::render {

struct ReferenceCheck {
  std::uint64_t rays = 0;       ///< in the sample
  std::uint64_t proven = 0;     ///< first root certain to within worst_pixels, or certain that there is none
  std::uint64_t undecided = 0;  ///< neither proven nor refuted to within a pixel
  std::uint64_t refuted = 0;    ///< certainly wrong
  std::uint64_t unchecked = 0;  ///< hits on solids, which have closed forms; scenes with CSG trees or without blobs
  double worst_pixels = 0;      ///< greatest δ of the proven rays
};

/// Checks the first hits of some of the rays, evenly spread: at most `sample` that meet a surface, and as many that
/// miss. `tracer` is the reference, made from `database` and `options`; `found` are its results on the rays.
[[nodiscard]] ReferenceCheck check_reference(const scene::Database& database, const TracerOptions& options,
                                             const Tracer& tracer, std::span<const Ray> rays,
                                             std::span<const RayMeasure> found, std::size_t sample);

}  // namespace isl::render
