// The queue of shadow rays: light that arrives unless something stands in its way. It is filled block by block of
// surface points, light by light, so that neighbours in the queue have similar directions.
#pragma once

#include "renderer/paths/direction_order.h"
#include "renderer/paths/path.h"
#include "renderer/paths/shadow_filter.h"
#include "renderer/trace/tracer.h"

#include <cstddef>
#include <span>
#include <vector>

namespace isl::render {

/// Its memory is kept from batch to batch.
class ShadowQueue {
 public:
  explicit ShadowQueue(RayKind kind) : kind_(kind) {}

  void clear() { size_ = 0; }

  /// Queues light `colour` for the sample of a path. It counts if nothing lies on `ray`, which leads to the light from
  /// the surface where the path ends.
  void push(const PathEntry& path, const Ray& ray, const Rgb& colour) { add(path, colour) = ray; }
  /// The same; all of the ray is for the caller to fill, which is quicker than to copy one that has just been made.
  [[nodiscard]] Ray& add(const PathEntry& path, const Rgb& colour) {
    if (size_ == rays_.size()) grow();
    lights_[size_] = {colour, path.sample, {path.bodies, path.contact}};
    return rays_[size_++];
  }

  /// Traces the queue and adds the light of every unoccluded ray to colours[sample], in the order of pushing: sums do
  /// not depend on the order in which the tracer works. certainties[sample] falls where a ray is undecided.
  void resolve(const Tracer& tracer, std::span<Rgb> colours, std::span<Certainty> certainties, TraceCounters& counters);
  /// The same where surfaces filter light. `lists` are those of the paths.
  void resolve(const ShadowFilter& filter, std::span<Rgb> colours, std::span<Certainty> certainties, PathLists& lists,
               ShadowFilterMemory& memory, TraceCounters& counters);

  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Light {
    Rgb colour;
    std::uint32_t sample;
    LightBegin begins;
  };

  void grow();
  /// Fills occluded_.
  void trace(const Tracer& tracer, TraceCounters& counters);

  RayKind kind_;
  // These may be longer than size_, so that one check makes room in both.
  std::vector<Ray> rays_;
  std::vector<Light> lights_;
  std::size_t size_ = 0;
  std::vector<std::uint8_t> occluded_;
  DirectionOrder by_direction_;
  std::vector<Ray> sorted_rays_;
  std::vector<std::uint8_t> sorted_occluded_;
  std::vector<Rgb> shares_;
  std::vector<LightBegin> begin_in_;
  std::vector<Certainty> certainties_;
};

}  // namespace isl::render
