#include "renderer/solvers/cells/extended_search.h"

#include "renderer/solvers/cells/stretch_search.h"

namespace isl::render {

std::optional<bool> is_inside(const LaidOutFields& fields, double t) {
  const std::optional<bool> inside = reference::is_inside_at(fields, t);
  return inside ? inside : wide_reference::is_inside_at(fields, t);
}

bool may_cross(const LaidOutFields& fields, double t0, double t1) { return reference::may_cross_on(fields, t0, t1); }

ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch) {
  const ExtendedAnswer answer = reference::search_stretch(fields, stretch);
  return answer.is_certain ? answer : wide_reference::search_stretch(fields, stretch);
}

}  // namespace isl::render
