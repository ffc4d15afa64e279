#include "tests/reference/reference_ray.h"

#include <algorithm>
#include <cmath>

namespace isl::reference {
namespace {

Vector<long double> middle(const Vector<Interval>& v) { return {v.x.middle(), v.y.middle(), v.z.middle()}; }

}  // namespace

FieldOnRay::FieldOnRay(const ReferenceField& field, const FieldRay& ray) : threshold_(field.threshold()) {
  for (const ReferenceComponent& component : field.components()) {
    Line local{ray.origin, ray.direction};
    if (component.has_transform()) {
      local.origin = transformed_point(ray.origin, component.component_from_blob());
      local.direction = transformed_vector(ray.direction, component.component_from_blob());
    }
    const std::optional<Support> support = support_on(component, local);
    if (!support) continue;
    if (parts_.empty() || support->begin < begin_) begin_ = support->begin;
    if (parts_.empty() || support->end > end_) end_ = support->end;
    parts_.push_back({&component, local, *support});
  }
}

std::optional<FieldOnRay::Support> FieldOnRay::support_on(const ReferenceComponent& component, const Line& line) {
  const ReferenceSkeleton& skeleton = component.skeleton();
  const long double reach = skeleton.reach(component.kernel().support().hi);
  const Vector<long double> w = middle(line.origin) - skeleton.bound_centre();
  const Vector<long double> d = middle(line.direction);
  const long double length_squared = squared_length(d);
  const long double nearest = -dot(w, d) / length_squared;
  // 2^-50 of the lengths involved covers the rounding of these lines with 13 bits to spare.
  const long double slack = (std::sqrt(squared_length(w)) + reach) * 0x1p-50L;
  const long double half_squared = (reach + slack) * (reach + slack) - squared_length(w + d * nearest);
  if (half_squared < 0) return std::nullopt;
  const long double half = (std::sqrt(half_squared) + slack) / std::sqrt(length_squared);
  return Support{nearest - half, nearest + half};
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

FieldRange FieldOnRay::Part::field_of(const DistanceOnLine& distance) const {
  return {component->strength() * component->kernel().value(distance.q),
          component->strength() * component->kernel().slope(distance.q) * distance.slope};
}

FieldRange FieldOnRay::at(const Active& active, long double t) const {
  FieldRange sum{-threshold_, 0};
  for (const std::uint32_t i : active) {
    const FieldRange part = parts_[i].field_of(parts_[i].distance_at(t));
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
    const DistanceOnLine first = part.distance_at(t0), last = part.distance_at(t1);
    const FieldRange range = part.field_of(part.component->skeleton().over({part.line, t0, t1, first, last}));
    sum.value = sum.value + range.value;
    sum.derivative = sum.derivative + range.derivative;
    value0 = value0 + part.field_of(first).value;
    value1 = value1 + part.field_of(last).value;
  }
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  sum.value = common(sum.value, value0 + sum.derivative * step);
  sum.value = common(sum.value, value1 - sum.derivative * step);
  return sum;
}

FieldOnRay::Magnitude FieldOnRay::magnitude_at(long double t) const {
  Magnitude magnitude;
  for (const Part& part : parts_) {
    const DistanceOnLine distance = part.distance_at(t);
    const FieldRange range = part.field_of(distance);
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
