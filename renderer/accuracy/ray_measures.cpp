#include "renderer/accuracy/ray_measures.h"

#include "base/check.h"
#include "base/parallel.h"
#include "renderer/image/camera.h"
#include "renderer/image/progress.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace isl::render {
namespace {

/// Rays of a task: as many as a wave has (renderer/render.cpp), so that batches cost what they cost there.
constexpr std::size_t kBlock = 1024;

/// Calls work(first, count) for blocks of `total` rays on all threads, until `stop`.
template <class Work>
void in_blocks(std::size_t total, const std::atomic<bool>* stop, const TellProgress& tell, const Work& work) {
  const std::size_t blocks = (total + kBlock - 1) / kBlock;
  Progress progress(tell);
  progress.begin_stage(1, blocks);
  parallel_for(blocks, [&](std::size_t block) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return;
    const std::size_t first = block * kBlock;
    work(first, std::min(kBlock, total - first));
    progress.step();
  });
}

/// Of this thread alone, so that being interrupted costs nothing.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

RayMeasure measure(const Tracer& tracer, const Ray& ray) {
  using Clock = std::chrono::steady_clock;
  Hit hit;
  TraceCounters counters;
  const Clock::time_point begin = Clock::now();
  tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
  const std::chrono::duration<float> seconds = Clock::now() - begin;
  return {.t = hit.is_miss() ? std::numeric_limits<double>::infinity() : hit.t,
          .field_evaluations = static_cast<std::uint32_t>(counters.field_evaluations),
          .solver_steps = static_cast<std::uint32_t>(counters.cells),
          .seconds = seconds.count()};
}

}  // namespace

std::vector<Ray> centre_rays(const scene::Camera& camera, int width, int height) {
  ISL_CHECK(width >= 1 && height >= 1, "picture of {}x{}", width, height);
  const CameraRays view(camera, width, height);
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) rays.push_back(view.through(x + 0.5, y + 0.5));
  }
  return rays;
}

void measure_each(const Tracer& tracer, std::span<const Ray> rays, std::span<RayMeasure> measures,
                  const std::atomic<bool>* stop, const TellProgress& tell) {
  ISL_CHECK(rays.size() == measures.size(), "{} {}", rays.size(), measures.size());
  in_blocks(rays.size(), stop, tell, [&](std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) measures[i] = measure(tracer, rays[i]);
  });
}

BatchCost cost_of(const Tracer& tracer, std::span<const Ray> rays, const std::atomic<bool>* stop,
                  const TellProgress& tell) {
  struct Share {
    BatchCost cost;
    std::vector<Hit> hits = std::vector<Hit>(kBlock);
  };
  PerThread<Share> shares;
  in_blocks(rays.size(), stop, tell, [&](std::size_t first, std::size_t count) {
    Share& share = shares.local();
    const double begin = thread_seconds();
    tracer.first_hits(rays.subspan(first, count), std::span(share.hits).first(count), share.cost.counters);
    share.cost.processor_seconds += thread_seconds() - begin;
  });
  BatchCost cost;
  shares.for_each([&](const Share& share) {
    cost.processor_seconds += share.cost.processor_seconds;
    cost.counters += share.cost.counters;
  });
  return cost;
}

}  // namespace isl::render
