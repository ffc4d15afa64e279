// Compares several settings of the tracer on the same rays: how far each is off from the truth, and how much each
// costs.
//
// Costs are measured in rounds, in each of which every setting has a turn. The result is the median over the rounds of
// the ratio to the base setting in the same round: a machine that slows down or is busy with something else slows both.
// Odd rounds take the settings backwards.
#pragma once

#include "base/run_limits.h"
#include "renderer/accuracy/ray_errors.h"
#include "renderer/accuracy/reference_hits.h"
#include "renderer/accuracy/shadow_rays.h"

#include <optional>
#include <vector>

namespace isl::render {

struct ComparisonOptions {
  int width = 400, height = 300;
  int threads = 0;  ///< 0 means one for each core
  int rounds = 5;   ///< at least 1
  /// Time budget of the rounds in seconds by the wall clock. A setting that takes more than its share runs in fewer
  /// rounds, but in one at least.
  double seconds = 60;
  bool shadows = false;  ///< also traces the shadow rays of what the exact solver meets
  TellProgress progress;
  RunLimits run;  ///< its flag ends the comparison early
};

/// The results and costs of one setting.
struct Measured {
  std::vector<RayMeasure> rays;  ///< row by row
  std::vector<RayError> errors;
  ErrorSummary summary;
  std::optional<ShadowSummary> shadows;  ///< set if shadows were asked for
  double evaluations_per_ray = 0;        ///< evaluations of fields, over all rays, shadow rays included
  double solver_steps_per_ray = 0;
  std::uint64_t uncertified_steps = 0;
  int rounds = 0;                ///< number of rounds that it took part in
  double relative_time = 0;      ///< median of the ratios to the base
  double time_spread = 0;        ///< median distance of the ratios from their median
  double processor_seconds = 0;  ///< median
};

struct Comparison {
  std::vector<Measured> settings;  ///< in the order asked for
  ReferenceSummary reference;
  bool complete = true;  ///< false if it was stopped; the other members are then meaningless
  double seconds = 0;    ///< total time by the wall clock
  /// The reason why a setting or the truth takes more memory than the run allows; the other members are then
  /// meaningless.
  std::optional<scene::Refusal> refusal;
};

/// Measures every one of `settings` against the truth; times are relative to settings[base]. `exact` are the options of
/// the exact solver, which finds the surfaces where shadow rays begin, and whether they are blocked.
[[nodiscard]] Comparison compare(const scene::Database& database, const TracerOptions& exact,
                                 const std::vector<TracerOptions>& settings, std::size_t base,
                                 const ComparisonOptions& options);

}  // namespace isl::render
