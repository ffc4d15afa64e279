#include "renderer/solvers/cells/extended_search.h"

#include "renderer/fields/component_table.h"
#include "renderer/reference/reference_tracer.h"

#include <vector>

namespace isl::render {
namespace {

using reference::Interval;

reference::ReferenceField field_of(const LaidOutFields& fields) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(fields.count);
  for (std::uint32_t i = 0; i < fields.count; ++i) numbers.push_back(fields.table->source[fields.items[i]]);
  return {*fields.table->database, *fields.table->blob, numbers};
}

/// The ray from t0 on.
reference::FieldRay ray_from(const LaidOutFields& fields, double t0) {
  const reference::Vector<Interval> direction = reference::interval_of(fields.direction);
  return {reference::interval_of(fields.origin) + direction * Interval(static_cast<long double>(t0)), direction};
}

reference::RayRoots roots_on(const LaidOutFields& fields, double t0, double t1, reference::RootOptions options) {
  options.t_max = static_cast<long double>(t1) - static_cast<long double>(t0);
  options.first_only = true;
  return reference::roots_along(field_of(fields), ray_from(fields, t0), options);
}

}  // namespace

std::optional<bool> is_inside(const LaidOutFields& fields, double t) {
  const reference::ReferenceField field = field_of(fields);
  const reference::FieldOnRay on_ray(field, ray_from(fields, t));
  const Interval value = on_ray.at(on_ray.all(), 0).value;
  if (value.lo > 0) return true;
  if (value.hi < 0) return false;
  return std::nullopt;
}

bool may_cross(const LaidOutFields& fields, double t0, double t1) {
  const reference::RayRoots roots = roots_on(fields, t0, t1, {});
  return !roots.crossings.empty() || !roots.touches.empty();
}

ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch) {
  const bool is_inside = stretch.side < 0;
  const reference::RayRoots roots = roots_on(
      fields, stretch.t0, stretch.t1, {.starts_on_root = stretch.starts_on_root, .coming_from = is_inside ? 1 : -1});
  const long double thin = rounding_of_places(fields.origin, fields.direction, stretch.t1);
  const long double end = static_cast<long double>(stretch.t1) - static_cast<long double>(stretch.t0);
  for (const reference::Touch& touch : roots.touches) {
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
  return {true, static_cast<double>(static_cast<long double>(stretch.t0) + roots.crossings.front().t)};
}

}  // namespace isl::render
