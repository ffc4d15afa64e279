#include "renderer/effects/effect.h"

#include "renderer/effects/not_rendered.h"

#include <algorithm>

namespace isl::render {

#define ISL_EFFECT(function) Effect function();
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

std::span<const Effect> all_effects() {
  static const std::vector<Effect> kEffects = [] {
    std::vector<Effect> effects{
#define ISL_EFFECT(function) function(),
#include "renderer/effects/effects.def"
#undef ISL_EFFECT
    };
    std::ranges::move(effects_not_rendered(), std::back_inserter(effects));
    return effects;
  }();
  return kEffects;
}

}  // namespace isl::render
