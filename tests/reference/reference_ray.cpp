#include "tests/reference/reference_ray.h"

#include <algorithm>
#include <cmath>

namespace isl::reference {
namespace {

Vector<Interval> hull(const Vector<Interval>& a, const Vector<Interval>& b) {
  return {reference::hull(a.x, b.x), reference::hull(a.y, b.y), reference::hull(a.z, b.z)};
}

Vector<long double> middle(const Vector<Interval>& v) { return {v.x.middle(), v.y.middle(), v.z.middle()}; }

/// The least value that a convex q can have on [t0, t1]: where the tangents at the ends meet, or an end that is lowest.
long double convex_minimum(long double t0, long double t1, const Interval& q0, const Interval& slope0,
                           const Interval& q1, const Interval& slope1) {
  if (slope0.lo >= 0) return q0.lo;
  if (slope1.hi <= 0) return q1.lo;
  const long double h = t1 - t0;
  const long double s = std::clamp((q0.lo - q1.lo + slope1.hi * h) / (slope1.hi - slope0.lo), 0.0L, h);
  // Left of t0 + s the falling tangent is above its value there, right of it the rising one: any s gives a bound.
  const Interval left = Interval(q0.lo) + Interval(slope0.lo) * Interval(s);
  const Interval right = Interval(q1.lo) - Interval(slope1.hi) * (Interval(h) - Interval(s));
  return std::min(left.lo, right.lo);
}

}  // namespace

FieldOnRay::FieldOnRay(const ReferenceField& field, const FieldRay& ray) : threshold_(field.threshold()) {
  for (const ReferenceComponent& component : field.components()) {
    FieldRay local = ray;
    if (component.has_transform()) {
      local.origin = transformed_point(ray.origin, component.component_from_blob());
      local.direction = transformed_vector(ray.direction, component.component_from_blob());
    }
    const std::optional<Stretch> stretch = support_on(component, local);
    if (!stretch) continue;
    if (parts_.empty() || stretch->begin < begin_) begin_ = stretch->begin;
    if (parts_.empty() || stretch->end > end_) end_ = stretch->end;
    parts_.push_back({&component, local.origin - component.skeleton().start(), local.direction, *stretch});
  }
}

std::optional<FieldOnRay::Stretch> FieldOnRay::support_on(const ReferenceComponent& component, const FieldRay& ray) {
  const ReferenceSkeleton& skeleton = component.skeleton();
  const long double reach = skeleton.reach(component.kernel().support().hi);
  const Vector<long double> w = middle(ray.origin) - skeleton.bound_centre();
  const Vector<long double> d = middle(ray.direction);
  const long double length_squared = squared_length(d);
  const long double nearest = -dot(w, d) / length_squared;
  // 2^-50 of the lengths involved covers the rounding of these lines with 13 bits to spare.
  const long double slack = (std::sqrt(squared_length(w)) + reach) * 0x1p-50L;
  const long double half_squared = (reach + slack) * (reach + slack) - squared_length(w + d * nearest);
  if (half_squared < 0) return std::nullopt;
  const long double half = (std::sqrt(half_squared) + slack) / std::sqrt(length_squared);
  return Stretch{nearest - half, nearest + half};
}

FieldOnRay::Active FieldOnRay::all() const {
  Active numbers(parts_.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  return numbers;
}

FieldOnRay::Active FieldOnRay::active(const Active& from, long double t0, long double t1) const {
  Active kept;
  kept.reserve(from.size());
  for (const std::uint32_t i : from) {
    if (parts_[i].support.begin <= t1 && parts_[i].support.end >= t0) kept.push_back(i);
  }
  return kept;
}

FieldOnRay::Distance FieldOnRay::distance_at(const Part& part, long double t) {
  const ReferenceSkeleton& skeleton = part.component->skeleton();
  const Vector<Interval> w = part.w + part.d * Interval(t);
  const Interval v = skeleton.nearest(w);
  const Vector<Interval> offset = skeleton.offset(w, v);
  const Interval radius_squared = square(skeleton.radius(v));
  if (radius_squared.lo <= 0) return {{0, kUnbounded}, {-kUnbounded, kUnbounded}};
  return {squared_length(offset) / radius_squared, Interval(2) * dot(offset, part.d) / radius_squared};
}

FieldOnRay::Distance FieldOnRay::distance_over(const Part& part, long double t0, long double t1, const Distance& first,
                                               const Distance& last) {
  const ReferenceSkeleton& skeleton = part.component->skeleton();
  if (skeleton.has_constant_radius()) {
    const long double least = convex_minimum(t0, t1, first.q, first.slope, last.q, last.slope);
    return {{std::max(least, 0.0L), std::max(first.q.hi, last.q.hi)},
            {first.slope.lo, std::max(first.slope.lo, last.slope.hi)}};
  }
  // A cone. What is linear in t is enclosed by its ends.
  const Vector<Interval> w0 = part.w + part.d * Interval(t0), w1 = part.w + part.d * Interval(t1);
  Interval v;
  if (skeleton.has_axis()) {
    const Interval foot0 = skeleton.foot(w0), foot1 = skeleton.foot(w1);
    const Vector<Interval> across = hull(skeleton.offset(w0, foot0), skeleton.offset(w1, foot1));
    v = skeleton.nearest(reference::hull(foot0, foot1), squared_length(across));
  } else {
    v = skeleton.nearest(w0);
  }
  const Interval radius_squared = square(skeleton.radius(v));
  if (radius_squared.lo <= 0) return {{0, kUnbounded}, {-kUnbounded, kUnbounded}};
  const Interval along = reference::hull(dot(w0, part.d), dot(w1, part.d)) - v * dot(skeleton.axis(), part.d);
  const Interval slope = Interval(2) * along / radius_squared;
  const Interval plain = squared_length(skeleton.offset(hull(w0, w1), v)) / radius_squared;
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  const Interval q = common(common(plain, first.q + slope * step), last.q - slope * step);
  return {{std::max(q.lo, 0.0L), q.hi}, slope};
}

FieldRange FieldOnRay::field_of(const Part& part, const Distance& distance) {
  const ReferenceComponent& component = *part.component;
  return {component.strength() * component.kernel().value(distance.q),
          component.strength() * component.kernel().slope(distance.q) * distance.slope};
}

FieldRange FieldOnRay::at(const Active& active, long double t) const {
  FieldRange sum{-threshold_, 0};
  for (const std::uint32_t i : active) {
    const FieldRange part = field_of(parts_[i], distance_at(parts_[i], t));
    sum.value = sum.value + part.value;
    sum.derivative = sum.derivative + part.derivative;
  }
  return sum;
}

FieldRange FieldOnRay::over(const Active& active, long double t0, long double t1) const {
  FieldRange sum{-threshold_, 0};
  Interval value0 = -threshold_, value1 = -threshold_;
  for (const std::uint32_t i : active) {
    const Part& part = parts_[i];
    const Distance first = distance_at(part, t0), last = distance_at(part, t1);
    const FieldRange range = field_of(part, distance_over(part, t0, t1, first, last));
    sum.value = sum.value + range.value;
    sum.derivative = sum.derivative + range.derivative;
    value0 = value0 + field_of(part, first).value;
    value1 = value1 + field_of(part, last).value;
  }
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  sum.value = common(sum.value, value0 + sum.derivative * step);
  sum.value = common(sum.value, value1 - sum.derivative * step);
  return sum;
}

FieldOnRay::Magnitude FieldOnRay::magnitude_at(long double t) const {
  Magnitude magnitude;
  for (const Part& part : parts_) {
    const Distance distance = distance_at(part, t);
    const FieldRange range = field_of(part, distance);
    if (range.value.hi == 0 && range.value.lo == 0) continue;
    const ReferenceComponent& component = *part.component;
    magnitude.values += range.value.magnitude();
    magnitude.derivatives += range.derivative.magnitude();
    magnitude.sensitivities += (component.strength() * component.kernel().slope(distance.q) * distance.q).magnitude();
    ++magnitude.count;
  }
  return magnitude;
}

bool FieldOnRay::stays_within(long double bound, long double t0, long double t1) const {
  struct Piece {
    long double t0, t1;
  };
  std::vector<Piece> open{{t0, t1}};
  const Active everything = all();
  // 10,000 pieces: far more than any stretch needs whose answer is clear.
  for (int step = 0; !open.empty(); ++step) {
    const Piece piece = open.back();
    open.pop_back();
    const Active near = active(everything, piece.t0, piece.t1);
    if (over(near, piece.t0, piece.t1).value.magnitude() <= bound) continue;
    const long double cut = piece.t0 + (piece.t1 - piece.t0) / 2;
    if (step > 10000 || !(piece.t0 < cut && cut < piece.t1) || at(near, cut).value.mignitude() > bound) return false;
    open.push_back({piece.t0, cut});
    open.push_back({cut, piece.t1});
  }
  return true;
}

}  // namespace isl::reference
