// The queue of shadow rays: light that arrives unless something stands in its way. Filled by shading, one wave at a
// time; exists only if the plan has shadows.
#pragma once

#include "renderer/shading/lighting.h"
#include "renderer/tracer.h"

#include <cstddef>
#include <span>
#include <vector>

namespace isl::render {

/// One wave's shadow rays. Memory is kept from wave to wave.
class ShadowQueue {
 public:
  void clear();

  /// Light for sample number `sample` of the wave, from the surface that `start` names at `position`. `path_length`:
  /// from the eye to there.
  void push(std::uint32_t sample, const LightArrival& arrival, const Vec3& position, RayStart start,
            double path_length);

  /// Traces the queue and adds the light of every unoccluded ray to colours[sample], in the order of pushing: sums do
  /// not depend on the order in which the tracer works.
  void resolve(const Tracer& tracer, std::span<Rgb> colours, TraceCounters& counters);

  [[nodiscard]] std::size_t size() const { return rays_.size(); }

 private:
  std::vector<Ray> rays_;
  std::vector<Rgb> light_;
  std::vector<std::uint32_t> samples_;
  std::vector<std::uint8_t> occluded_;
};

}  // namespace isl::render
