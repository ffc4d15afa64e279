#include "renderer/solvers/cells/stretch_search.h"

#include "renderer/fields/component_table.h"
#include "renderer/reference/reference_tracer.h"

#include <vector>

namespace isl::ISL_REFERENCE {
namespace {

using render::ExtendedAnswer, render::LaidOutFields, render::OpenStretch;

ReferenceField field_of(const LaidOutFields& fields) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(fields.count);
  for (std::uint32_t i = 0; i < fields.count; ++i) numbers.push_back(fields.table->source[fields.items[i]]);
  return {*fields.table->database, *fields.table->blob, numbers};
}

/// The ray from t0 on.
FieldRay ray_from(const LaidOutFields& fields, double t0) {
  const Vector<Interval> direction = interval_of(fields.direction);
  return {interval_of(fields.origin) + direction * Interval(static_cast<Real>(t0)), direction};
}

Real length_of(double t0, double t1) { return static_cast<Real>(t1) - static_cast<Real>(t0); }

RayRoots roots_on(const LaidOutFields& fields, double t0, double t1, RootOptions options) {
  options.t_max = length_of(t0, t1);
  options.first_only = true;
  return roots_along(field_of(fields), ray_from(fields, t0), options);
}

}  // namespace

std::optional<bool> is_inside_at(const LaidOutFields& fields, double t) {
  const ReferenceField field = field_of(fields);
  const FieldOnRay on_ray(field, ray_from(fields, t));
  const Interval value = on_ray.at(on_ray.all(), 0).value;
  if (value.lo > 0) return true;
  if (value.hi < 0) return false;
  return std::nullopt;
}

bool may_cross_on(const LaidOutFields& fields, double t0, double t1) {
  const RayRoots roots = roots_on(fields, t0, t1, {});
  return !roots.crossings.empty() || !roots.touches.empty();
}

ExtendedAnswer search_stretch(const LaidOutFields& fields, const OpenStretch& stretch) {
  const bool is_inside = stretch.side < 0;
  const RayRoots roots = roots_on(fields, stretch.t0, stretch.t1,
                                  {.starts_on_root = stretch.starts_on_root, .coming_from = is_inside ? 1 : -1});
  const Real thin = render::rounding_of_places(fields.origin, fields.direction, stretch.t1);
  const Real end = length_of(stretch.t0, stretch.t1);
  for (const Touch& touch : roots.touches) {
    // Beyond a touch at either end the sign is not known.
    const bool is_thin = touch.end - touch.begin <= thin && touch.begin > 0 && touch.end < end;
    if (!is_thin) return {};
  }
  if (roots.starts_inside != is_inside) {
    // A ray that starts on the surface was given its side by double precision, and cannot be back at once.
    if (stretch.starts_on_root) return {};
    return {true, stretch.t0};
  }
  if (roots.crossings.empty()) return {true, std::nullopt};
  return {true, static_cast<double>(static_cast<Real>(stretch.t0) + roots.crossings.front().t)};
}

}  // namespace isl::ISL_REFERENCE
