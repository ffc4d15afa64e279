#include "renderer/solvers/cells/stretch_search.h"

#include "renderer/extended/root_search.h"
#include "renderer/fields/component_table.h"

#include <vector>

namespace isl::ISL_EXTENDED {
namespace {

using render::ExtendedAnswer, render::LaidOutFields, render::OpenStretch, render::RaySteps;

/// The sum of the fields along the ray from t0 on.
FieldOnRay field_from(const LaidOutFields& fields, double t0, RaySteps& steps) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(fields.count);
  for (std::uint32_t i = 0; i < fields.count; ++i) numbers.push_back(fields.table->source[fields.items[i]]);
  const Vector<Interval> direction = interval_of(fields.direction);
  const Line ray{interval_of(fields.origin) + direction * Interval(static_cast<Real>(t0)), direction};
  return {*fields.table->database, *fields.table->blob, numbers, ray, steps};
}

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

ExtendedAnswer search_stretch(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps) {
  const bool is_inside = stretch.side < 0;
  const Real end = length_of(stretch.t0, stretch.t1);
  FieldOnRay field = field_from(fields, stretch.t0, steps);
  const FirstRoot root =
      first_root(field, {.t_max = end, .starts_on_root = stretch.starts_on_root, .coming_from = is_inside ? 1 : -1});
  if (steps.is_spent()) return {};
  const Real thin = render::rounding_of_places(fields.origin, fields.direction, stretch.t1);
  for (const Touch& touch : root.touches) {
    // Beyond a touch at either end the sign is not known.
    const bool is_thin = touch.end - touch.begin <= thin && touch.begin > 0 && touch.end < end;
    if (!is_thin) return {};
  }
  if (root.starts_inside != is_inside) {
    // A ray that starts on the surface was given its side by double precision, and cannot be back at once.
    if (stretch.starts_on_root) return {};
    return {true, stretch.t0};
  }
  if (!root.crossing) return {true, std::nullopt};
  return {true, static_cast<double>(static_cast<Real>(stretch.t0) + *root.crossing)};
}

}  // namespace isl::ISL_EXTENDED
