// Questions about finishes and lights that several effects ask, for their records.
#pragma once

#include "renderer/effects/effect.h"

namespace isl::render {

/// For Effect::find: an item of the finishes in use calls for the effect if `is_used` holds. `what` is the item as the
/// language writes it.
[[nodiscard]] inline auto find_finishes(std::string_view what, scene::FinishItem item,
                                        bool (*is_used)(const scene::Finish&)) {
  return [=](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
    for (const Use<scene::Finish>& finish : use.finishes()) {
      if (is_used(*finish.record)) requests.add(what, finish.record->said_at[item], finish.user);
    }
  };
}

/// The same for the lights.
[[nodiscard]] inline auto find_lights(std::string_view what, scene::LightItem item,
                                      bool (*is_used)(const scene::Light&)) {
  return [=](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
    for (const Use<scene::Light>& light : use.lights()) {
      if (is_used(*light.record)) requests.add(what, light.record->said_at[item], light.user);
    }
  };
}

/// For Effect::leave_out: calls change(light) with every light of the scene.
template <class Change>
[[nodiscard]] auto change_lights(Change change) {
  return [=](scene::Database& database) {
    for (scene::Light& light : database.lights) change(light);
    for (scene::Group& group : database.groups) {
      for (scene::Light& light : group.lights) change(light);
    }
  };
}

}  // namespace isl::render
