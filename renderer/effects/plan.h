// The effects that a scene calls for. They are found once, before anything is traced: the integrator runs the stages of
// the effects in the plan and knows of no others, so an effect that is left out costs nothing. `isl plan`, the
// statistics and the refusals read the same lists.
#pragma once

#include "renderer/effects/effect.h"

#include <string>
#include <string_view>
#include <vector>

namespace isl::render {

struct PlannedEffect {
  const Effect* effect = nullptr;
  std::vector<Request> requests;  ///< the statements that call for it
  std::string reason;             ///< why it is left out; lower case, no full stop
};

struct Plan {
  std::vector<PlannedEffect> called_for;  ///< rendered
  std::vector<PlannedEffect> left_out;    ///< not called for, beyond the quality, or excluded
  std::vector<PlannedEffect> refused;     ///< called for, and not rendered yet

  /// True if the effect is rendered.
  [[nodiscard]] bool has(std::string_view name) const;
  /// True if some effect has noise, so that the samples of pixels are to be spread over what it integrates.
  [[nodiscard]] bool is_soft() const;
};

/// The number of rays that an effect spawned in a rendering.
[[nodiscard]] std::uint64_t spawned_rays(const Plan& plan, const PathCounts& counts, const Effect& effect);

struct PlanOptions {
  int quality = 9;                        ///< as POV-Ray's +Q: each effect says from which quality on it is drawn
  std::vector<std::string> without = {};  ///< names of effects to leave out, even if the scene calls for them
};

[[nodiscard]] Plan plan_of(const scene::Database& database, const PlanOptions& options = {});

/// True if the database has to change before the plan is rendered, because it calls for effects that are refused or
/// excluded.
[[nodiscard]] bool must_leave_out(const Plan& plan);

/// Changes the database so that it no longer calls for these effects.
void leave_out(const Plan& plan, scene::Database& database);

}  // namespace isl::render
