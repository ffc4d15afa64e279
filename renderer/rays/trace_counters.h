// Counters of the work that tracing did.
#pragma once

#include <algorithm>
#include <cstdint>

namespace isl::render {

/// Work done, for --stats. Merged over threads; sums do not depend on their order.
struct TraceCounters {
  std::uint64_t field_evaluations = 0;
  std::uint64_t uncertified_steps = 0;  ///< intervals that double precision could not decide
  std::uint64_t undecided_steps = 0;    ///< those of them that stayed undecided
  std::uint64_t spent_rays = 0;         ///< rays whose bound of steps ended their search of a blob
  std::uint64_t vain_rays = 0;          ///< rays that took more than a tenth of it and stayed undecided
  std::uint64_t most_ray_steps = 0;     ///< the greatest number of steps that a ray took in a blob
  std::uint64_t cells = 0;
  std::uint64_t shading_evaluations = 0;  ///< evaluations of fields at hit points, for normals and textures

  TraceCounters& operator+=(const TraceCounters& other) {
    field_evaluations += other.field_evaluations;
    uncertified_steps += other.uncertified_steps;
    undecided_steps += other.undecided_steps;
    spent_rays += other.spent_rays;
    vain_rays += other.vain_rays;
    most_ray_steps = std::max(most_ray_steps, other.most_ray_steps);
    cells += other.cells;
    shading_evaluations += other.shading_evaluations;
    return *this;
  }
};

}  // namespace isl::render
