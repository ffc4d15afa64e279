#include "renderer/accuracy/ray_measures.h"

#include "base/check.h"
#include "renderer/accuracy/ray_blocks.h"
#include "renderer/film/camera.h"
#include "renderer/film/tiles.h"

#include <array>
#include <chrono>
#include <ctime>
#include <limits>

namespace isl::render {
namespace {

/// Processor time of this thread alone, so that interruptions do not count.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

RayMeasure measure(const Tracer& tracer, const Ray& ray) {
  Hit hit;
  TraceCounters counters;
  const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
  const std::chrono::duration<float> seconds = std::chrono::steady_clock::now() - begin;
  return {.t = hit.is_miss() ? std::numeric_limits<double>::infinity() : hit.t,
          .counters = counters,
          .seconds = seconds.count()};
}

}  // namespace

std::vector<Ray> centre_rays(const scene::Camera& camera, int width, int height,
                             std::shared_ptr<const CameraFunctions> functions) {
  ISL_CHECK(width >= 1 && height >= 1, "picture of {}x{}", width, height);
  const CameraRays view(camera, width, height, std::move(functions));
  RecurringAngles angles;
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) rays.push_back(view.through(x + 0.5, y + 0.5, angles));
  }
  return rays;
}

std::vector<std::uint32_t> batch_order(int width, int height) {
  std::vector<std::uint32_t> order;
  order.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<Pixel> pixels;
  for (const PixelRect& tile : tiles_of({0, 0, width, height}, TileOrder::rows)) {
    pixels_of(tile, pixels);
    for (const Pixel& pixel : pixels) order.push_back(static_cast<std::uint32_t>(pixel.y * width + pixel.x));
  }
  return order;
}

void measure_each(const Tracer& tracer, std::span<const Ray> rays, std::span<RayMeasure> measures, const StopFlag* stop,
                  const TellProgress& tell) {
  ISL_CHECK(rays.size() == measures.size(), "{} {}", rays.size(), measures.size());
  in_blocks(rays.size(), stop, tell, [&](std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) measures[i] = measure(tracer, rays[i]);
  });
}

std::vector<double> hits_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop) {
  std::vector<double> places(rays.size());
  in_blocks(rays.size(), stop, {}, [&](std::size_t first, std::size_t count) {
    std::array<Hit, kBlock> hits;
    TraceCounters unread;
    tracer.first_hits(rays.subspan(first, count), std::span(hits).first(count), unread);
    for (std::size_t i = 0; i < count; ++i) {
      places[first + i] = hits[i].is_miss() ? std::numeric_limits<double>::infinity() : hits[i].t;
    }
  });
  return places;
}

namespace {

/// `trace` gets the thread's share of the cost, the first ray and the number of rays.
template <class Trace>
BatchCost cost_of_blocks(std::size_t total, const StopFlag* stop, const TellProgress& tell, const Trace& trace) {
  PerThread<BatchCost> shares;
  in_blocks(total, stop, tell, [&](std::size_t first, std::size_t count) {
    BatchCost& share = shares.local();
    const double begin = thread_seconds();
    trace(share, first, count);
    share.processor_seconds += thread_seconds() - begin;
  });
  BatchCost cost;
  shares.for_each([&](const BatchCost& share) {
    cost.processor_seconds += share.processor_seconds;
    cost.counters += share.counters;
  });
  return cost;
}

}  // namespace

BatchCost cost_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop, const TellProgress& tell) {
  return cost_of_blocks(rays.size(), stop, tell, [&](BatchCost& share, std::size_t first, std::size_t count) {
    std::array<Hit, kBlock> hits;
    tracer.first_hits(rays.subspan(first, count), std::span(hits).first(count), share.counters);
  });
}

BatchCost shadow_cost_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop) {
  return cost_of_blocks(rays.size(), stop, {}, [&](BatchCost& share, std::size_t first, std::size_t count) {
    std::array<std::uint8_t, kBlock> occluded;
    tracer.occlusions(rays.subspan(first, count), std::span(occluded).first(count), share.counters);
  });
}

}  // namespace isl::render
