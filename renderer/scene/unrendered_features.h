// The rows of what cannot be drawn yet: for each kind of record, what to look for and how to do without. Internal to
// renderer/scene.
#pragma once

#include "renderer/scene/database.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace isl::scene {

template <class Record>
struct Feature {
  std::string_view what;
  bool (*is_used)(const Record&);
  void (*leave_out)(Record&);
};

struct WorldFeature {
  std::string_view what;
  std::size_t (*count)(const Database&);
  OriginId (*origin)(const Database&);  ///< of the first, where there is one
  void (*leave_out)(Database&);
};

[[nodiscard]] std::span<const Feature<Camera>> camera_features();
[[nodiscard]] std::span<const Feature<Light>> light_features();
[[nodiscard]] std::span<const Feature<Object>> object_features();
[[nodiscard]] std::span<const Feature<Group>> group_features();
/// Of what stands in no object.
[[nodiscard]] std::span<const WorldFeature> world_features();

}  // namespace isl::scene
