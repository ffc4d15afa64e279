// Compares the tracer with the reference, ray by ray: which hits, where, and, if they differ, whether double precision
// allows it. Tests state the counts that they expect; the texts name the worst rays. Knows the tracer only by its rays
// and hits.
#pragma once

#include "renderer/reference/reference_tracer.h"
#include "renderer/trace/tracer.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace isl::reference {

using TraceBatch = std::function<void(std::span<const render::Ray>, std::span<render::Hit>)>;
/// Every answer is a render::Occlusion.
using OccludeBatch = std::function<void(std::span<const render::Ray>, std::span<std::uint8_t>)>;

struct AgreementOptions {
  render::Tolerance tolerance;
  double pixel_angle = 1e-3;    ///< radians
  std::size_t most_listed = 8;  ///< rays described in `listed`, and in `listed_flagged`
};

/// The result of a comparison. A ray counts in at most one of the six kinds of difference.
struct Agreement {
  std::size_t rays = 0;
  std::size_t hits = 0;  ///< rays that hit in the reference

  std::size_t missed = 0;     ///< the reference hits, the tracer does not
  std::size_t invented = 0;   ///< the other way round
  std::size_t misplaced = 0;  ///< both hit, farther apart than the tolerance
  std::size_t reversed = 0;   ///< both hit the same place, one from inside and one from outside

  /// Differences that no computation in double precision can avoid: F stays within its rounding error of zero between
  /// the two answers.
  std::size_t lost_in_rounding = 0;
  /// Differences in features thinner than the length at which a solver may stop: a thousandth of the tolerance.
  std::size_t too_thin = 0;

  std::size_t flagged = 0;        ///< rays that the tracer says it could not decide
  std::size_t wrong_flagged = 0;  ///< differences of the first four kinds at those

  long double worst_depth =
      0;  ///< largest difference in t where both hit and rounding does not excuse it, in scene units
  long double worst_pixels = 0;             ///< the same in pixels of each ray's footprint
  std::vector<std::string> listed;          ///< the first rays that differ
  std::vector<std::string> listed_flagged;  ///< the first that were not decided

  [[nodiscard]] std::size_t disagreements() const { return missed + invented + misplaced + reversed; }
  [[nodiscard]] std::string text() const;
};

/// The reference's results, for comparing several tracers on the same rays.
using Truth = std::vector<std::optional<ReferenceScene::Hit>>;
[[nodiscard]] Truth truth_of(const ReferenceScene& scene, std::span<const render::Ray> rays);

/// Precondition: `truth` is truth_of(scene, rays).
[[nodiscard]] Agreement compare_first_hits(const ReferenceScene& scene, const Truth& truth, const TraceBatch& trace,
                                           std::span<const render::Ray> rays, const AgreementOptions& options);
[[nodiscard]] inline Agreement compare_first_hits(const ReferenceScene& scene, const TraceBatch& trace,
                                                  std::span<const render::Ray> rays, const AgreementOptions& options) {
  return compare_first_hits(scene, truth_of(scene, rays), trace, rays, options);
}

/// Compares only hit or miss. Precondition: every blob throws shadows.
[[nodiscard]] Agreement compare_occlusions(const ReferenceScene& scene, const OccludeBatch& occlude,
                                           std::span<const render::Ray> rays, const AgreementOptions& options);

/// The error that F at t may have when it is computed in double precision (the derivation is in agreement.cpp).
[[nodiscard]] long double rounding_band(const FieldOnRay& field, long double origin_size, long double t);

}  // namespace isl::reference
