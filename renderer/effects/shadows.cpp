#include "renderer/effects/shadows.h"

namespace isl::render {

void ShadowQueue::clear() {
  rays_.clear();
  light_.clear();
  samples_.clear();
}

void ShadowQueue::push(std::uint32_t sample, const LightArrival& arrival, const Vec3& position, RayStart start,
                       double path_length) {
  rays_.push_back({position, arrival.direction, arrival.distance, path_length, start});
  light_.push_back(arrival.colour);
  samples_.push_back(sample);
}

void ShadowQueue::resolve(const Tracer& tracer, std::span<Rgb> colours, TraceCounters& counters) {
  if (rays_.empty()) return;
  occluded_.resize(rays_.size());
  tracer.occlusions(rays_, occluded_, counters);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    if (occluded_[i] == 0) colours[samples_[i]] += light_[i];
  }
}

}  // namespace isl::render
