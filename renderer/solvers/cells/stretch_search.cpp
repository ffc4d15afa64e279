#include "renderer/solvers/cells/stretch_search.h"

#include "renderer/extended/root_search.h"
#include "renderer/fields/component_table.h"

#include <vector>

namespace isl::ISL_EXTENDED {
namespace {

using render::LaidOutFields, render::OpenStretch, render::RaySteps, render::StretchAnswer;

/// The sum of the fields along the ray from t0 on.
FieldOnRay field_from(const LaidOutFields& fields, double t0, RaySteps& steps) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(fields.count);
  for (std::uint32_t i = 0; i < fields.count; ++i) numbers.push_back(fields.table->source[fields.items[i]]);
  const Vector<Interval> direction = interval_of(fields.direction);
  const Line ray{interval_of(fields.origin) + direction * Interval(static_cast<Real>(t0)), direction};
  return {*fields.table->database, *fields.table->blob, numbers, ray, steps};
}

/// A search may stop once Newton's steps are this share of the rounding of places. It then still makes sure that the
/// sign changes within four times that length, so the crossing is known to a quarter of the rounding.
constexpr double kEnough = 1.0 / 16;

long double native(Real t) { return static_cast<long double>(t); }

Real length_of(double t0, double t1) { return static_cast<Real>(t1) - static_cast<Real>(t0); }

}  // namespace

std::optional<bool> is_inside_at(const LaidOutFields& fields, double t, RaySteps& steps) {
  const FieldOnRay field = field_from(fields, t, steps);
  const Interval value = field.at(field.all(), 0).value;
  if (steps.is_spent() || value.sign() == 0) return std::nullopt;
  return value.lo > 0;
}

bool may_cross_on(const LaidOutFields& fields, double t0, double t1, RaySteps& steps) {
  FieldOnRay field = field_from(fields, t0, steps);
  const FirstRoot root = first_root(field, {.t_max = length_of(t0, t1)});
  return steps.is_spent() || root.crossing || !root.touches.empty();
}

StretchAnswer search_stretch(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps) {
  const bool is_inside = stretch.side < 0;
  const Real end = length_of(stretch.t0, stretch.t1);
  const double thin = render::rounding_of_places(fields.origin, fields.direction, stretch.t1);
  FieldOnRay field = field_from(fields, stretch.t0, steps);
  const FirstRoot root = first_root(field, {.t_max = end,
                                            .starts_on_root = stretch.starts_on_root,
                                            .coming_from = is_inside ? 1 : -1,
                                            .enough = kEnough * thin});
  StretchAnswer answer;
  if (steps.is_spent()) return answer;
  answer.is_open = false;
  for (const Touch& touch : root.touches) {
    // Beyond a touch at either end the sign is not known.
    const bool is_thin = touch.end - touch.begin <= thin && touch.begin > 0 && touch.end < end;
    if (!is_thin) answer.doubts.push_back({native(touch.begin), native(touch.end)});
  }
  if (root.starts_inside != is_inside) {
    // A ray that starts on the surface was given its side by double precision, and cannot be back at once.
    if (stretch.starts_on_root || !answer.doubts.empty()) return {};
    answer.crossing = 0;
  } else if (root.crossing) {
    answer.crossing = native(*root.crossing);
    answer.slack = native(root.slack);
    answer.is_placed = kDigits == 113 || root.slack <= thin;
    if (root.bracket) answer.bracket = {native(root.bracket->begin), native(root.bracket->end)};
  }
  return answer;
}

std::optional<long double> crossing_in(const LaidOutFields& fields, const OpenStretch& stretch,
                                       const StretchAnswer& known, RaySteps& steps) {
  const FieldOnRay field = field_from(fields, stretch.t0, steps);
  const double thin = render::rounding_of_places(fields.origin, fields.direction, stretch.t1);
  const Bracket bracket{known.bracket->begin, known.bracket->end};
  const Real t = crossing_in(field, bracket, *known.crossing, stretch.side < 0 ? 1 : -1, kEnough * thin);
  if (steps.is_spent()) return std::nullopt;
  return native(t);
}

}  // namespace isl::ISL_EXTENDED
