// Several settings of the tracer on the same rays: how far each is off from the exact one, and what each costs.
//
// Costs are measured in rounds, in each of which every setting has its turn, and told as the median over the rounds of
// the ratio to the setting that all are compared with, in the same round: a machine that slows down or is busy with
// something else slows both. Rounds go through the settings forwards and backwards in turn.
#pragma once

#include "renderer/accuracy/ray_errors.h"
#include "renderer/accuracy/reference_check.h"
#include "renderer/accuracy/shadow_rays.h"

#include <optional>
#include <vector>

namespace isl::render {

struct ComparisonOptions {
  int width = 400, height = 300;
  int threads = 0;  ///< 0: one a core
  int rounds = 5;   ///< at least 1
  /// Wall-clock seconds for the rounds: what takes more than its share of them takes part in fewer, but in one at
  /// least.
  double seconds = 60;
  bool shadows = false;            ///< the shadow rays too, of what the reference meets
  std::size_t checked_rays = 256;  ///< sample of check_reference
  TellProgress progress;
  const std::atomic<bool>* stop = nullptr;
};

/// What one setting found and cost.
struct Measured {
  std::vector<RayMeasure> rays;  ///< row by row
  std::vector<RayError> errors;
  ErrorSummary summary;
  std::optional<ShadowSummary> shadows;  ///< where asked for
  double evaluations_per_ray = 0;        ///< of fields, over all rays, shadow rays included
  double solver_steps_per_ray = 0;
  std::uint64_t uncertified_steps = 0;
  int rounds = 0;                ///< that it took part in
  double relative_time = 0;      ///< median of the ratios to the base
  double time_spread = 0;        ///< median distance of the ratios from their median
  double processor_seconds = 0;  ///< median
};

struct Comparison {
  std::vector<Measured> settings;  ///< in the order asked for
  ReferenceCheck check;
  bool complete = true;  ///< false when stopped: the rest says nothing then
  double seconds = 0;    ///< by the wall clock, in all
};

/// Measures every one of `settings` against `reference`; times are relative to settings[base].
[[nodiscard]] Comparison compare(const scene::Database& database, const TracerOptions& reference,
                                 const std::vector<TracerOptions>& settings, std::size_t base,
                                 const ComparisonOptions& options);

}  // namespace isl::render
