#include "tests/reference/rounding_rule.h"

#include "renderer/reference/reference_skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::reference {
namespace {

/// The greatest coordinates of a component in the blob's space.
scene::Vec3 size_of(const scene::Database& database, const scene::Blob& blob, const scene::Component& component) {
  const bool has_direction = scene::has(component.skeleton, scene::kDirectionB);
  double around = component.radius_a;
  if (component.skeleton == scene::Skeleton::cone) around = std::max(around, component.radius_b);
  if (has_direction && !scene::is_endless(component.skeleton)) around += component.radius_b;  // a circle or a disc
  scene::Vec3 own(0);
  const auto take = [&](const scene::Vec3& point) {
    for (int i = 0; i < 3; ++i) own[i] = std::max(own[i], std::abs(point[i]) + around);
  };
  take(component.a);
  if (scene::has(component.skeleton, scene::kPointB | scene::kEndB)) take(component.b);
  if (scene::has(component.skeleton, scene::kCorner)) take(blob.corners[component.corner]);
  if (component.transform == scene::kIdentity) return own;
  const scene::Matrix& m = database.transforms[index(component.transform)].matrix;
  scene::Vec3 mapped(0);
  for (int j = 0; j < 3; ++j) {
    mapped[j] = std::abs(m[3][j]);
    for (int i = 0; i < 3; ++i) mapped[j] += own[i] * std::abs(m[i][j]);
  }
  return mapped;
}

/// Σ|∂f/∂x||x| over the axes of the component's own space, where the coordinates in the blob's space are `at_most`.
long double moved_by_one_unit(const Vector<long double>& gradient, const long double (&at_most)[3],
                              const scene::Transform* transform) {
  const long double slopes[3] = {gradient.x, gradient.y, gradient.z};
  long double moved = 0;
  for (int i = 0; i < 3; ++i) {
    if (transform == nullptr) {
      moved += std::abs(slopes[i]) * at_most[i];
      continue;
    }
    long double slope = 0, size = std::abs(static_cast<long double>(transform->inverse[3][i]));
    for (int j = 0; j < 3; ++j) {
      slope += slopes[j] * static_cast<long double>(transform->matrix[i][j]);
      size += at_most[j] * std::abs(static_cast<long double>(transform->inverse[j][i]));
    }
    moved += std::abs(slope) * size;
  }
  return moved;
}

/// True if the places at two t of a ray differ by at most eight units in the last place of the ray's coordinates there.
bool differ_by_eight_units(const render::Ray& ray, long double a, long double b) {
  const Vector<long double> d = exactly(ray.direction), o = exactly(ray.origin);
  const auto is_near = [&](long double origin, long double along) {
    const long double coordinate = std::max(std::abs(origin), std::abs(along) * std::max(std::abs(a), std::abs(b)));
    return std::abs(along) * std::abs(a - b) <= 8 * 0x1p-52L * coordinate;
  };
  return is_near(o.x, d.x) && is_near(o.y, d.y) && is_near(o.z, d.z);
}

}  // namespace

RoundingRule::RoundingRule(const scene::Database& database) : field_(database, database.blobs.front()) {
  const scene::Blob& blob = database.blobs.front();
  for (const scene::Component& component : blob.components) {
    sizes_.push_back(size_of(database, blob, component));
    const bool is_mapped = component.transform != scene::kIdentity;
    transforms_.push_back(is_mapped ? &database.transforms[index(component.transform)] : nullptr);
  }
}

long double RoundingRule::band(const FieldOnRay& field, const render::Ray& ray, long double t) const {
  const FieldOnRay::Magnitude at = field.magnitude_at(t);
  const Vector<long double> d = exactly(ray.direction), p = exactly(ray.origin) + d * t;
  long double moved = 0;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    const FieldSample sample = field_.components()[i].sample(p);
    if (sample.value == 0) continue;
    const auto coordinate = [&](double origin, long double along, double own) {
      return std::max({std::abs(static_cast<long double>(origin)), std::abs(t * along), static_cast<long double>(own)});
    };
    const long double at_most[3] = {coordinate(ray.origin.x, d.x, sizes_[i].x),
                                    coordinate(ray.origin.y, d.y, sizes_[i].y),
                                    coordinate(ray.origin.z, d.z, sizes_[i].z)};
    moved += moved_by_one_unit(sample.gradient, at_most, transforms_[i]);
  }
  const long double terms = static_cast<long double>(at.count) + 16;
  return 0x1p-52L * (8 * moved + terms * (at.values + std::abs(field.threshold())) + 4 * at.sensitivities);
}

long double RoundingRule::excess(const render::Ray& ray, double found) const {
  const FieldOnRay field(field_, field_ray(ray));
  return field.at(found).value.magnitude() / band(field, ray, found);
}

bool RoundingRule::agree(const FieldOnRay& field, const render::Ray& ray, const Crossing* crossing,
                         const std::optional<double>& found, bool is_inside) const {
  constexpr long double kAnything = std::numeric_limits<long double>::infinity();
  const long double to = found ? *found : field.end();
  // Asked for first, because F may turn within the eight units: a slope that is judged just before a support begins
  // does not know the component behind its border.
  if (found && crossing != nullptr) {
    const long double known = std::clamp(to, crossing->t - crossing->slack, crossing->t + crossing->slack);
    if (differ_by_eight_units(ray, to, known)) return true;
  }
  const bool is_late = crossing != nullptr && crossing->t < to;
  const long double from = is_late ? std::min(crossing->t + crossing->slack, to) : to;
  // Behind a missed surface other components may allow more than the place where it was missed.
  const long double most =
      found ? std::max({band(field, ray, from), band(field, ray, from + (to - from) / 2), band(field, ray, to)})
            : band(field, ray, from);
  if (!is_late) return field.stays_within({-most, most}, to, to);
  return field.stays_within(is_inside ? FieldOnRay::Band{-most, kAnything} : FieldOnRay::Band{-kAnything, most}, from,
                            to);
}

RoundingRule::Judged RoundingRule::judge(const render::Ray& ray, const std::optional<double>& found) const {
  const RayRoots roots = roots_along(field_, field_ray(ray), {});
  const bool is_hit = !roots.crossings.empty();
  if (!roots.touches.empty() && (!is_hit || roots.touches.front().begin < roots.crossings.front().t))
    return {Verdict::undecided, is_hit};
  if (!is_hit && !found) return {Verdict::agrees, is_hit};
  const FieldOnRay field(field_, field_ray(ray));
  if (agree(field, ray, is_hit ? &roots.crossings.front() : nullptr, found, roots.starts_inside))
    return {Verdict::agrees, is_hit};
  return {!is_hit ? Verdict::invented : found ? Verdict::misplaced : Verdict::missed, is_hit};
}

}  // namespace isl::reference
