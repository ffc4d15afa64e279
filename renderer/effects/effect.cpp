#include "renderer/effects/effect.h"

#include "renderer/effects/not_rendered.h"
#include "renderer/effects/statements.h"

#include <algorithm>

namespace isl::render {

#define ISL_EFFECT(function, group) Effect function();
#include "renderer/effects/effects.def"
#undef ISL_EFFECT

void Requests::add(std::string_view what, OriginId word, OriginId user) {
  const auto known = std::ranges::find(requests_, what, &Request::what);
  if (known != requests_.end()) {
    ++known->count;
  } else if (word == OriginId{}) {
    requests_.push_back({std::string(what), user});
  } else {
    requests_.push_back({std::string(what), word, user});
  }
}

namespace {

/// Without its stages if its group was left out when the program was built.
Effect as_built(Effect effect, std::string_view group) {
  constexpr std::string_view kLeftOut = "without: " ISL_WITHOUT_EFFECTS;
  if (kLeftOut.find(group) == std::string_view::npos) return effect;
  effect.is_rendered = false;
  effect.lack = "was left out of this program when it was built";
  effect.stages = {};
  return effect;
}

}  // namespace

std::span<const Effect> all_effects() {
  static const std::vector<Effect> kEffects = [] {
    std::vector<Effect> effects{
#define ISL_EFFECT(function, group) as_built(function(), #group),
#include "renderer/effects/effects.def"
#undef ISL_EFFECT
    };
    std::ranges::move(effects_not_rendered(), std::back_inserter(effects));
    return effects;
  }();
  return kEffects;
}

std::span<const scene::StatementKind* const> statement_kinds() {
  static const std::vector<const scene::StatementKind*> kKinds = [] {
    std::vector<const scene::StatementKind*> kinds;
    for (const Effect& effect : all_effects()) {
      if (effect.statement) kinds.push_back(effect.statement);
    }
    return kinds;
  }();
  return kKinds;
}

}  // namespace isl::render
