// For machines without numbers of 113 bits beside a shorter long double: nothing can be said with more digits.
#include "renderer/solvers/cells/stretch_search.h"

namespace isl::wide_extended {

render::StretchAnswer search_stretch(const render::LaidOutFields&, const render::OpenStretch&, render::RaySteps&) {
  return {};
}
std::optional<bool> is_inside_at(const render::LaidOutFields&, double, render::RaySteps&) { return std::nullopt; }
std::optional<long double> crossing_in(const render::LaidOutFields&, const render::OpenStretch&,
                                       const render::StretchAnswer&, render::RaySteps&) {
  return std::nullopt;
}

}  // namespace isl::wide_extended
