// Shadow rays of a picture's centre rays, the same for every setting, so that results can be compared. They begin on
// the surfaces that the reference found and lead to the lights for which rendering would trace them.
#pragma once

#include "renderer/accuracy/ray_measures.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

/// One ray for each point that `rays` meet and each light in front of it that throws shadows, in this order.
[[nodiscard]] std::vector<Ray> shadow_rays(const scene::Database& database, const Tracer& reference,
                                           std::span<const Ray> rays, const StopFlag* stop = nullptr);

/// For each ray, 1 if something stands in its way, else 0.
[[nodiscard]] std::vector<std::uint8_t> occlusions_of(const Tracer& tracer, std::span<const Ray> rays,
                                                      const StopFlag* stop = nullptr);

struct ShadowSummary {
  std::uint64_t rays = 0;
  std::uint64_t leaks = 0;          ///< light where the reference has shadow
  std::uint64_t false_shadows = 0;  ///< shadow where the reference has light
};

[[nodiscard]] ShadowSummary summarise_shadows(std::span<const std::uint8_t> found,
                                              std::span<const std::uint8_t> reference);

}  // namespace isl::render
