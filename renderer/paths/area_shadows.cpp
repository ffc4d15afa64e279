#include "renderer/paths/area_shadows.h"

#include "renderer/numerics/sample_points.h"
#include "renderer/shading/lighting.h"

#include <array>
#include <cmath>

namespace isl::render {
namespace {

/// POV-Ray's measure of the difference of two colours, and the difference from which on a part is divided.
double difference(const Rgb& a, const Rgb& b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}
constexpr double kDifferent = 0.1;

std::size_t cells_of(const scene::AreaLight& area) {
  return static_cast<std::size_t>(area.count_a) * static_cast<std::size_t>(area.count_b);
}

}  // namespace

void AreaShadows::clear() {
  targets_.clear();
  answers_at_.clear();
}

bool AreaShadows::push(const AreaTarget& target) {
  const scene::AreaLight& area = *target.light->area;
  const std::size_t first = answers_at_.size(), size = first + cells_of(area);
  if (size > answers_at_.capacity()) {
    // A list grows to at most twice its size.
    if (!charge_.grow(2 * (size - answers_at_.capacity()) * sizeof(std::uint32_t))) return false;
  }
  answers_at_.resize(size, kNotAsked);
  targets_.push_back({target, edges_of(area, target.to_centre.direction), first});
  return true;
}

std::uint32_t& AreaShadows::answer_at(const Estimate& estimate, int u, int v) {
  const scene::AreaLight& area = *estimate.target.light->area;
  return answers_at_[estimate.first_cell + static_cast<std::size_t>(u) * static_cast<std::size_t>(area.count_b) +
                     static_cast<std::size_t>(v)];
}

void AreaShadows::ask(const ShadowTracer& tracer, const Estimate& estimate, int u, int v) {
  std::uint32_t& answer = answer_at(estimate, u, v);
  if (answer != kNotAsked) return;
  const AreaTarget& target = estimate.target;
  const scene::Light& light = *target.light;
  UnitPoint by{0.5, 0.5};
  if (target.jitter_seed)
    by = sample_point(derived_seed(*target.jitter_seed, static_cast<std::uint32_t>(u * light.area->count_b + v)), 0);
  const Vec3 source = light.location + area_offset(*light.area, estimate.edges, u + (by.u - 0.5), v + (by.v - 0.5));
  const LightSample way = sample_light_from(light, source, target.to_centre.origin);
  // Filled where it stays: to copy a ray that has just been made takes longer than to make it.
  Ray& ray = rays_.emplace_back();
  ray.origin = target.to_centre.origin;
  ray.direction = way.direction;
  ray.t_max = way.distance;
  ray.path_length = target.to_centre.path_length;
  ray.start = target.to_centre.start;
  if (tracer.windows && LightWindows::has_window(light)) tracer.windows->trim(light, std::span(&ray, 1));
  if (ray.t_max < 0) {
    answer = kNoLight;
    rays_.pop_back();
    return;
  }
  answer = static_cast<std::uint32_t>(answers_.size() + rays_.size() - 1);
  samples_.push_back(target.sample);
  begin_in_.push_back(target.begins);
}

Rgb AreaShadows::share_from(const Estimate& estimate, int u, int v) {
  const std::uint32_t answer = answer_at(estimate, u, v);
  return answer == kNoLight ? Rgb(0) : answers_[answer];
}

void AreaShadows::finish(const Part& part) {
  Estimate& estimate = targets_[part.target];
  const AreaPart& at = part.part;
  // The corners, one side after the other.
  const std::array<Rgb, 4> corners{share_from(estimate, at.u1, at.v1), share_from(estimate, at.u2, at.v1),
                                   share_from(estimate, at.u2, at.v2), share_from(estimate, at.u1, at.v2)};
  bool is_divided = at.can_be_divided();
  if (is_divided && part.level >= estimate.target.light->area->adaptive) {
    const Rgb& light = estimate.target.arriving;
    is_divided = false;
    for (std::size_t i = 0; i < corners.size(); ++i)
      is_divided |= difference(corners[i] * light, corners[(i + 1) % corners.size()] * light) > kDifferent;
  }
  if (!is_divided) {
    estimate.share += (corners[0] + corners[1] + corners[2] + corners[3]) * (part.weight / 4);
    return;
  }
  // The quarters of a single row or column are two pairs of the same part.
  const bool is_row = at.v1 == at.v2, is_column = at.u1 == at.u2;
  const double weight = part.weight / (is_row || is_column ? 2 : 4);
  for (unsigned which = 0; which < 4; ++which) {
    if ((is_row && (which & 2U) != 0) || (is_column && (which & 1U) != 0)) continue;
    divided_.push_back({part.target, part.level + 1, weight, at.quarter(which)});
  }
}

std::uint64_t AreaShadows::resolve(const ShadowTracer& tracer, std::span<Rgb> colours,
                                   std::span<Certainty> certainties) {
  answers_.clear();
  parts_.clear();
  for (std::uint32_t i = 0; i < targets_.size(); ++i)
    parts_.push_back({i, 0, 1, AreaPart::whole(*targets_[i].target.light->area)});
  while (!parts_.empty()) {
    rays_.clear();
    samples_.clear();
    begin_in_.clear();
    for (const Part& part : parts_) {
      const Estimate& estimate = targets_[part.target];
      ask(tracer, estimate, part.part.u1, part.part.v1);
      ask(tracer, estimate, part.part.u2, part.part.v1);
      ask(tracer, estimate, part.part.u2, part.part.v2);
      ask(tracer, estimate, part.part.u1, part.part.v2);
    }
    const std::size_t first = answers_.size();
    answers_.resize(first + rays_.size());
    certainties_.resize(rays_.size());
    tracer.run(rays_, begin_in_, std::span(answers_).subspan(first), certainties_, occluded_);
    for (std::size_t i = 0; i < rays_.size(); ++i) lower(certainties[samples_[i]], certainties_[i]);
    divided_.clear();
    for (const Part& part : parts_) finish(part);
    parts_.swap(divided_);
  }
  for (const Estimate& estimate : targets_) colours[estimate.target.sample] += estimate.target.colour * estimate.share;
  clear();
  return answers_.size();
}

}  // namespace isl::render
