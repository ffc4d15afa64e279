#include "renderer/solvers/cells/extended_search.h"

#include "renderer/solvers/cells/stretch_search.h"

namespace isl::render {

std::optional<bool> is_inside(const LaidOutFields& fields, double t, RaySteps& steps) {
  const std::optional<bool> inside = extended::is_inside_at(fields, t, steps);
  return inside ? inside : wide_extended::is_inside_at(fields, t, steps);
}

bool may_cross(const LaidOutFields& fields, double t0, double t1, RaySteps& steps) {
  return extended::may_cross_on(fields, t0, t1, steps);
}

ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps) {
  const ExtendedAnswer answer = extended::search_stretch(fields, stretch, steps);
  return answer.is_certain ? answer : wide_extended::search_stretch(fields, stretch, steps);
}

}  // namespace isl::render
