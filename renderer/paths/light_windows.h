// The objects that lights are `projected_through`: light comes along a ray only if the ray meets the light's object,
// and begins at the surface of the object that is nearest to the lit point. Whatever stands between that and the light
// throws no shadow, as in POV-Ray.
#pragma once

#include "renderer/queries/object_tracer.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

/// Immutable once it is made; shared by all threads.
class LightWindows {
 public:
  /// Prepares the objects of all lights of the database that have one. Reports in `refusal` if there is not enough
  /// memory.
  LightWindows(const scene::Database& database, const RunLimits& run, std::optional<scene::Refusal>& refusal);

  [[nodiscard]] static bool has_window(const scene::Light& light) { return light.projected_through != scene::kNoGroup; }

  /// Shortens rays that lead from lit points to a light that has a window. t_max becomes negative for rays that no
  /// light comes along.
  void trim(const scene::Light& light, std::span<Ray> rays) const;

 private:
  std::map<scene::GroupId, std::unique_ptr<const ObjectTracer>> objects_;
};

}  // namespace isl::render
