#include "renderer/reference/reference_ray.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace isl::reference {
namespace {

Vector<long double> middle(const Vector<Interval>& v) { return {v.x.middle(), v.y.middle(), v.z.middle()}; }

}  // namespace

FieldOnRay::FieldOnRay(const ReferenceField& field, const FieldRay& ray)
    : branches_(&field.branches()), ray_(ray), threshold_(field.threshold()) {
  for (std::size_t i = 0; i < field.components().size(); ++i) {
    const ReferenceComponent& component = field.components()[i];
    Line local{ray.origin, ray.direction};
    if (component.has_transform()) {
      local.origin = transformed_point(ray.origin, component.component_from_blob());
      local.direction = transformed_vector(ray.direction, component.component_from_blob());
    }
    const std::optional<Support> support = support_on(component, local);
    if (!support) continue;
    const long double root_q = std::sqrt(component.kernel().support().hi);
    const std::optional<ChangeOnLine> change = component.skeleton().change_on(local, root_q);
    const long double begin = change ? change->begin : support->begin, end = change ? change->end : support->end;
    if (parts_.empty() || begin < begin_) begin_ = begin;
    if (parts_.empty() || end > end_) end_ = end;
    parts_.push_back({&component, field.branch_of(i), local, *support});
  }
}

std::optional<FieldOnRay::Support> FieldOnRay::support_on(const ReferenceComponent& component, const Line& line) {
  const ReferenceSkeleton& skeleton = component.skeleton();
  if (skeleton.change_on(line, 1)) return Support{-kUnbounded, kUnbounded};
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

/// The value of the greatest of several sums, and the hull of the derivatives of those that may be the greatest.
FieldRange FieldOnRay::total(std::vector<FieldRange>& sums) const {
  fold_maxima(*branches_, [&](std::uint32_t parent, std::span<const std::uint32_t> rivals) {
    Interval greatest = sums[rivals[0]].value;
    for (const std::uint32_t b : rivals)
      greatest = {std::max(greatest.lo, sums[b].value.lo), std::max(greatest.hi, sums[b].value.hi)};
    std::optional<Interval> derivative;
    for (const std::uint32_t b : rivals) {
      if (sums[b].value.hi < greatest.lo) continue;
      derivative = derivative ? hull(*derivative, sums[b].derivative) : sums[b].derivative;
    }
    sums[parent].value = sums[parent].value + greatest;
    sums[parent].derivative = sums[parent].derivative + *derivative;
  });
  return {sums[0].value - threshold_, sums[0].derivative};
}

FieldRange FieldOnRay::at(const Active& active, long double t) const {
  std::vector<FieldRange> sums(branches_->size());
  for (const std::uint32_t i : active) {
    const FieldRange part = parts_[i].component->at(parts_[i].line, t);
    FieldRange& sum = sums[parts_[i].branch];
    sum.value = sum.value + part.value;
    sum.derivative = sum.derivative + part.derivative;
  }
  return total(sums);
}

FieldRange FieldOnRay::over(const Active& active, long double t0, long double t1) const {
  std::vector<FieldRange> sums(branches_->size()), firsts(sums), lasts(sums);
  for (const std::uint32_t i : active) {
    const Part& part = parts_[i];
    const ReferenceComponent::Stretched range = part.component->over(part.line, t0, t1);
    FieldRange& sum = sums[part.branch];
    sum.value = sum.value + range.all.value;
    sum.derivative = sum.derivative + range.all.derivative;
    firsts[part.branch].value = firsts[part.branch].value + range.first.value;
    lasts[part.branch].value = lasts[part.branch].value + range.last.value;
  }
  // A maximum has edges. But the slope between any two of its values lies between slopes of the sums that are the
  // greatest there, so the mean-value form holds for it too.
  FieldRange sum = total(sums);
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  sum.value = common(sum.value, total(firsts).value + sum.derivative * step);
  sum.value = common(sum.value, total(lasts).value - sum.derivative * step);
  return sum;
}

FieldOnRay::Magnitude FieldOnRay::magnitude_at(long double t) const {
  const auto middle = [](const Vector<Interval>& v) {
    return Vector<long double>{v.x.middle(), v.y.middle(), v.z.middle()};
  };
  const Vector<long double> direction = middle(ray_.direction), place = middle(ray_.origin) + direction * t;
  const long double speed = std::sqrt(squared_length(direction));
  Magnitude magnitude;
  for (const Part& part : parts_) {
    const FieldRange range = part.component->at(part.line, t);
    if (range.value.hi == 0 && range.value.lo == 0) continue;
    magnitude.values += range.value.magnitude();
    magnitude.gradients += std::sqrt(squared_length(part.component->sample(place).gradient)) * speed;
    magnitude.sensitivities += part.component->sensitivity_at(part.line, t);
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
  // 10,000 pieces are far more than any stretch with a clear result needs.
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
