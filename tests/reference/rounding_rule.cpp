#include "tests/reference/rounding_rule.h"

#include "renderer/reference/reference_skeleton.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

RoundingRule::RoundingRule(const scene::Database& database) : field_(database, database.blobs.front()) {
  const scene::Blob& blob = database.blobs.front();
  for (const scene::Component& component : blob.components) sizes_.push_back(size_of(database, blob, component));
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
    moved += std::abs(sample.gradient.x) * coordinate(ray.origin.x, d.x, sizes_[i].x) +
             std::abs(sample.gradient.y) * coordinate(ray.origin.y, d.y, sizes_[i].y) +
             std::abs(sample.gradient.z) * coordinate(ray.origin.z, d.z, sizes_[i].z);
  }
  const long double terms = static_cast<long double>(at.count) + 16;
  return 0x1p-52L * (8 * moved + terms * (at.values + std::abs(field.threshold())) + 4 * at.sensitivities);
}

long double RoundingRule::excess(const render::Ray& ray, double found) const {
  const FieldOnRay field(field_, field_ray(ray));
  return field.at(field.all(), found).value.magnitude() / band(field, ray, found);
}

RoundingRule::Judged RoundingRule::judge(const render::Ray& ray, const std::optional<double>& found) const {
  const RayRoots roots = roots_along(field_, field_ray(ray), {});
  const bool is_hit = !roots.crossings.empty();
  if (!roots.touches.empty() && (!is_hit || roots.touches.front().begin < roots.crossings.front().t))
    return {Verdict::undecided, is_hit};
  if (!is_hit && !found) return {Verdict::agrees, is_hit};
  const FieldOnRay field(field_, field_ray(ray));
  long double from, to;
  if (!is_hit) {
    from = to = *found;
  } else {
    from = roots.crossings.front().t;
    to = found ? *found : roots.crossings.size() > 1 ? roots.crossings[1].t : field.end();
  }
  if (from > to) std::swap(from, to);
  const long double allowed =
      std::max({band(field, ray, from), band(field, ray, from + (to - from) / 2), band(field, ray, to)});
  if (field.stays_within(allowed, from, to)) return {Verdict::agrees, is_hit};
  return {!is_hit ? Verdict::invented : found ? Verdict::misplaced : Verdict::missed, is_hit};
}

}  // namespace isl::reference
