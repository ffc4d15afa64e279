#include "renderer/paths/shadow_queue.h"

namespace isl::render {

void ShadowQueue::grow() {
  constexpr std::size_t kFirst = 1024;
  const std::size_t room = rays_.empty() ? kFirst : 2 * rays_.size();
  rays_.resize(room);
  lights_.resize(room);
}

void ShadowQueue::trace(const Tracer& tracer, TraceCounters& counters) {
  const std::span<const Ray> rays = std::span(rays_).first(size_);
  occluded_.resize(size_);
  if (kind_ != RayKind::around) return tracer.occlusions(rays, occluded_, counters, kind_);
  const std::span<const std::uint32_t> order = by_direction_.of(rays);
  sorted_rays_.clear();
  for (const std::uint32_t i : order) sorted_rays_.push_back(rays[i]);
  sorted_occluded_.resize(size_);
  tracer.occlusions(sorted_rays_, sorted_occluded_, counters, kind_);
  for (std::size_t i = 0; i < size_; ++i) occluded_[order[i]] = sorted_occluded_[i];
}

void ShadowQueue::resolve(const Tracer& tracer, std::span<Rgb> colours, std::span<Certainty> certainties,
                          TraceCounters& counters) {
  if (size_ == 0) return;
  trace(tracer, counters);
  for (std::size_t i = 0; i < size_; ++i) {
    if (occluded_[i] == kOccluded) continue;
    const std::uint32_t sample = lights_[i].sample;
    colours[sample] += lights_[i].colour;
    if (occluded_[i] == kUndecidedOcclusion) lower(certainties[sample], Certainty::undecided);
  }
}

void ShadowQueue::resolve(const ShadowFilter& filter, std::span<Rgb> colours, std::span<Certainty> certainties,
                          PathLists& lists, ShadowFilterMemory& memory, TraceCounters& counters) {
  if (size_ == 0) return;
  begin_in_.clear();
  for (std::size_t i = 0; i < size_; ++i) begin_in_.push_back(lights_[i].begins);
  shares_.resize(size_);
  certainties_.assign(size_, Certainty::certified);
  filter.run(std::span(rays_).first(size_), kind_, begin_in_, shares_, certainties_, lists, memory, counters);
  for (std::size_t i = 0; i < size_; ++i) {
    const std::uint32_t sample = lights_[i].sample;
    colours[sample] += lights_[i].colour * shares_[i];
    lower(certainties[sample], certainties_[i]);
  }
}

}  // namespace isl::render
