#include "renderer/extended/field_on_ray.h"

#include <algorithm>
#include <map>

namespace isl::ISL_EXTENDED {
namespace {

const FieldRange kEverything{{-kInfiniteReal, kInfiniteReal}, {-kInfiniteReal, kInfiniteReal}};

Vector<Real> middle(const Vector<Interval>& v) { return {v.x.middle(), v.y.middle(), v.z.middle()}; }
Real widths(const Vector<Interval>& v) { return v.x.width() + v.y.width() + v.z.width(); }

const scene::Transform& transform_of(const scene::Database& database, const scene::Component& component) {
  static const scene::Transform kIdentityTransform;
  return component.transform == scene::kIdentity ? kIdentityTransform : database.transforms[index(component.transform)];
}

FieldRange sum(const FieldRange& a, const FieldRange& b) { return {a.value + b.value, a.derivative + b.derivative}; }

}  // namespace

FieldOnRay::FieldOnRay(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers,
                       const Line& ray, render::RaySteps& steps)
    : threshold_(blob.threshold), steps_(steps) {
  std::map<scene::KernelId, ExtendedKernel> kernels;
  const std::span corners(blob.corners.begin(), blob.corners.size());
  for (const std::uint32_t number : numbers) {
    if (!take(1)) return;
    const scene::Component& component = blob.components[number];
    const scene::Kernel& kernel = database.kernels[index(component.kernel)];
    const ExtendedKernel& profile = kernels.try_emplace(component.kernel, kernel).first->second;
    add({component, kernel, profile, transform_of(database, component), corners}, ray);
  }
}

void FieldOnRay::add(const ExtendedComponent& component, const Line& ray) {
  const Line local = component.enter(ray);
  const std::optional<Support> support = support_on(component, local);
  if (!support) return;
  const Real root_q = sqrt(component.kernel().support().hi);
  const std::optional<ChangeOnLine> change = component.skeleton().change_on(local, root_q);
  const Real begin = change ? change->begin : support->begin, end = change ? change->end : support->end;
  if (parts_.empty() || begin < begin_) begin_ = begin;
  if (parts_.empty() || end > end_) end_ = end;
  parts_.push_back({component, local, *support});
}

bool FieldOnRay::take(std::size_t components) const {
  return steps_.take(components * (kDigits == 113 ? render::kStepsOfWide : render::kStepsOfLongDouble));
}

std::optional<FieldOnRay::Support> FieldOnRay::support_on(const ExtendedComponent& component, const Line& line) {
  const ExtendedSkeleton& skeleton = component.skeleton();
  if (skeleton.change_on(line, 1)) return Support{-kUnbounded, kUnbounded};
  const Real reach = skeleton.reach(component.kernel().support().hi);
  const Vector<Real> w = middle(line.origin) - skeleton.bound_centre();
  const Vector<Real> d = middle(line.direction);
  const Real length_squared = squared_length(d);
  const Real nearest = -dot(w, d) / length_squared;
  // The true line is off by the widths of its intervals, where a large shift cancels, and 2^-50 of the lengths involved
  // covers the rounding of these lines with 13 bits to spare.
  const Real far = sqrt(squared_length(w)), length = sqrt(length_squared);
  const Real slack = (far + reach) * 0x1p-50L + widths(line.origin) + widths(line.direction) * (far / length);
  const Real half_squared = (reach + slack) * (reach + slack) - squared_length(w + d * nearest);
  if (half_squared < 0) return std::nullopt;
  const Real half = (sqrt(half_squared) + slack) / length;
  return Support{nearest - half, nearest + half};
}

FieldOnRay::Active FieldOnRay::all() const {
  Active numbers(parts_.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  return numbers;
}

FieldRange FieldOnRay::at(const Active& active, Real t) const {
  if (!take(active.size())) return kEverything;
  FieldRange total;
  for (const std::uint32_t i : active) total = sum(total, parts_[i].component.at(parts_[i].line, t));
  return {total.value - threshold_, total.derivative};
}

FieldRange FieldOnRay::at(const Active& active, Real t, Samples& samples) const {
  samples.clear();
  if (!take(active.size())) return kEverything;
  FieldRange total;
  for (const std::uint32_t i : active) {
    samples.push_back(parts_[i].component.point(parts_[i].line, t));
    total = sum(total, parts_[i].component.at(samples.back()));
  }
  return {total.value - threshold_, total.derivative};
}

FieldOnRay::Piece FieldOnRay::piece(const Active& from, Real t0, Real t1) const {
  Piece piece{t0, t1, {}, {}, {}};
  if (!take(2 * from.size())) return piece;
  for (const std::uint32_t i : from) {
    const Part& part = parts_[i];
    if (part.support.begin > t1 || part.support.end < t0) continue;
    piece.active.push_back(i);
    piece.first.push_back(part.component.point(part.line, t0));
    piece.last.push_back(part.component.point(part.line, t1));
  }
  return piece;
}

FieldRange FieldOnRay::over(Piece& piece) const {
  if (!take(piece.active.size())) return kEverything;
  const Real t0 = piece.t0, t1 = piece.t1;
  FieldRange whole, first, last;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < piece.active.size(); ++k) {
    const Part& part = parts_[piece.active[k]];
    if (part.support.begin > t1 || part.support.end < t0) continue;
    const FieldRange range = part.component.over(part.line, t0, t1, piece.first[k], piece.last[k]);
    if (range.value.lo == 0 && range.value.hi == 0) continue;
    whole = sum(whole, range);
    first = sum(first, part.component.at(piece.first[k]));
    last = sum(last, part.component.at(piece.last[k]));
    piece.active[kept] = piece.active[k];
    piece.first[kept] = piece.first[k];
    piece.last[kept] = piece.last[k];
    ++kept;
  }
  piece.active.resize(kept);
  piece.first.resize(kept);
  piece.last.resize(kept);
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  Interval value = whole.value - threshold_;
  value = common(value, first.value - threshold_ + whole.derivative * step);
  value = common(value, last.value - threshold_ - whole.derivative * step);
  return {value, whole.derivative};
}

FieldRange FieldOnRay::over(const Active& active, Real t0, Real t1) const {
  Piece whole = piece(active, t0, t1);
  return over(whole);
}

}  // namespace isl::ISL_EXTENDED
