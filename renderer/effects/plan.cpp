#include "renderer/effects/plan.h"

#include <algorithm>
#include <utility>

namespace isl::render {
namespace {

/// Why the options exclude the effect; empty if they do not.
std::string_view excluded(const Effect& effect, const PlanOptions& options) {
  if (options.quality < effect.from_quality) return "`--quality` is too low for it";
  if (options.quality > effect.to_quality) return "`--quality` is high enough for light";
  if (std::ranges::find(options.without, effect.name) != options.without.end()) return "excluded by --without";
  return {};
}

}  // namespace

bool Plan::has(std::string_view name) const {
  return std::ranges::any_of(called_for, [&](const PlannedEffect& planned) { return planned.effect->name == name; });
}

bool Plan::is_soft() const {
  return std::ranges::any_of(called_for, [](const PlannedEffect& planned) { return planned.effect->is_soft; });
}

std::uint64_t spawned_rays(const Plan& plan, const PathCounts& counts, const Effect& effect) {
  std::size_t stage = 0;
  for (const PlannedEffect& planned : plan.called_for) {
    if (!planned.effect->stages.spawn) continue;
    if (planned.effect == &effect) return stage < counts.spawned.size() ? counts.spawned[stage] : 0;
    ++stage;
  }
  return 0;
}

Plan plan_of(const scene::Database& database, const PlanOptions& options) {
  const SceneUse use(database);
  Plan plan;
  for (const Effect& effect : all_effects()) {
    Requests requests;
    std::string_view reason = "the scene does not call for it";
    effect.find(use, requests, reason);
    PlannedEffect planned{&effect, requests.take(), {}};
    if (planned.requests.empty()) {
      planned.reason = reason;
    } else {
      planned.reason = excluded(effect, options);
    }
    if (!planned.reason.empty()) {
      plan.left_out.push_back(std::move(planned));
    } else {
      (effect.is_rendered ? plan.called_for : plan.refused).push_back(std::move(planned));
    }
  }
  return plan;
}

namespace {

/// Calls visit(effect) with each effect that the database calls for and the picture does not have.
template <class Visit>
void for_each_lacking(const Plan& plan, Visit&& visit) {
  for (const PlannedEffect& planned : plan.refused) {
    if (planned.effect->leave_out) visit(*planned.effect);
  }
  for (const PlannedEffect& planned : plan.left_out) {
    if (!planned.requests.empty() && planned.effect->leave_out) visit(*planned.effect);
  }
}

}  // namespace

bool must_leave_out(const Plan& plan) {
  bool must = false;
  for_each_lacking(plan, [&](const Effect&) { must = true; });
  return must;
}

void leave_out(const Plan& plan, scene::Database& database) {
  for_each_lacking(plan, [&](const Effect& effect) { effect.leave_out(database); });
}

}  // namespace isl::render
