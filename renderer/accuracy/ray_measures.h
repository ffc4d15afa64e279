// Costs and hits of rays: the rays of a picture are traced one by one, so that work and time are known for each, and in
// batches, as rendering traces them. Knows nothing of references or pictures.
#pragma once

#include "base/stop_flag.h"
#include "renderer/film/camera_functions.h"
#include "renderer/scene/camera.h"
#include "renderer/trace/tracer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace isl::render {

struct RayMeasure {
  double t = 0;              ///< along the ray, scene units; infinite for a miss
  TraceCounters counters{};  ///< of this ray
  float seconds = 0;         ///< by the wall clock, including some 30 ns of the clock itself

  [[nodiscard]] bool is_miss() const { return t == std::numeric_limits<double>::infinity(); }
};

/// Receives the share done (0 to 1) now and then, from any thread but one call at a time.
using TellProgress = std::function<void(double)>;

/// Rays through the middles of the pixels of a picture, row by row. `functions` are those of a `user_defined` camera.
[[nodiscard]] std::vector<Ray> centre_rays(const scene::Camera& camera, int width, int height,
                                           std::shared_ptr<const CameraFunctions> functions = nullptr);

/// The indices of the same rays in the order in which rendering traces them, neighbours together.
[[nodiscard]] std::vector<std::uint32_t> batch_order(int width, int height);

/// measures[i] becomes the measure of rays[i], on as many threads as loops have here (base/parallel.h). Once `stop` is
/// true, the rest stays as it is.
void measure_each(const Tracer& tracer, std::span<const Ray> rays, std::span<RayMeasure> measures,
                  const StopFlag* stop = nullptr, const TellProgress& tell = {});

/// The t of each ray's hit, infinite for a miss, as found in batches.
[[nodiscard]] std::vector<double> hits_of(const Tracer& tracer, std::span<const Ray> rays,
                                          const StopFlag* stop = nullptr);

struct BatchCost {
  double processor_seconds = 0;  ///< sum over all threads, so that other load on the machine hardly counts
  TraceCounters counters;
};

/// The cost of finding the first hits of all rays in batches, as rendering traces them.
[[nodiscard]] BatchCost cost_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop = nullptr,
                                const TellProgress& tell = {});

/// The cost of testing whether shadow rays are occluded, likewise.
[[nodiscard]] BatchCost shadow_cost_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop = nullptr);

}  // namespace isl::render
