#include "renderer/reference/reference_ray.h"

#include <algorithm>
#include <span>

namespace isl::ISL_REFERENCE {
namespace {

Vector<Real> middle(const Vector<Interval>& v) { return {v.x.middle(), v.y.middle(), v.z.middle()}; }
Real widths(const Vector<Interval>& v) { return v.x.width() + v.y.width() + v.z.width(); }

/// The greater of two functions; where either may be, its derivative is that of either.
FieldRange greater(const FieldRange& a, const FieldRange& b) {
  const Interval value(std::max(a.value.lo, b.value.lo), std::max(a.value.hi, b.value.hi));
  if (a.value.hi < b.value.lo) return {value, b.derivative};
  if (b.value.hi < a.value.lo) return {value, a.derivative};
  return {value, hull(a.derivative, b.derivative)};
}

}  // namespace

FieldOnRay::FieldOnRay(const ReferenceField& field, const FieldRay& ray)
    : ray_(ray), is_unblended_(field.is_unblended()), threshold_(field.threshold()) {
  std::vector<std::uint32_t> numbers;
  field.components_along(RoughLine(ray), numbers);
  for (const std::uint32_t i : numbers) {
    const ReferenceComponent& component = field.components()[i];
    Line local{ray.origin, ray.direction};
    if (const scene::Matrix* const matrix = component.component_from_blob()) {
      local.origin = transformed_point(ray.origin, *matrix);
      local.direction = transformed_vector(ray.direction, *matrix);
    }
    const std::optional<Support> support = support_on(component, local);
    if (!support) continue;
    const Real root_q = sqrt(component.kernel().support().hi);
    const std::optional<ChangeOnLine> change = component.skeleton().change_on(local, root_q);
    const Real begin = change ? change->begin : support->begin, end = change ? change->end : support->end;
    if (parts_.empty() || begin < begin_) begin_ = begin;
    if (parts_.empty() || end > end_) end_ = end;
    parts_.push_back({&component, field.branch_of(i), local, *support});
  }
  if (field.branch_count() > 1) find_maxima(field);
}

/// Numbers the branches that matter on this ray anew, since a blob may have thousands.
void FieldOnRay::find_maxima(const ReferenceField& field) {
  constexpr std::uint32_t kIdle = scene::kNone;
  std::vector<std::uint32_t> here(field.branch_count(), kIdle);
  here[0] = 0;
  std::uint32_t count = 1;
  const auto meet = [&](std::uint32_t branch) {
    if (here[branch] == kIdle) here[branch] = count++;
  };
  for (Part& part : parts_) {
    meet(part.branch);
    part.branch = here[part.branch];
  }
  for (const Maximum& all : field.maxima()) {  // inner ones first, so that their parents are known to matter
    MaximumHere maximum{{0, {}}, false};
    for (const std::uint32_t rival : all.rivals) {
      if (here[rival] != kIdle) {
        maximum.maximum.rivals.push_back(here[rival]);
      } else {
        maximum.has_idle = true;
      }
    }
    if (maximum.maximum.rivals.empty()) continue;
    meet(all.parent);
    maximum.maximum.parent = here[all.parent];
    maxima_.push_back(std::move(maximum));
  }
  branch_count_ = count;
}

std::optional<FieldOnRay::Support> FieldOnRay::support_on(const ReferenceComponent& component, const Line& line) {
  const ReferenceSkeleton& skeleton = component.skeleton();
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

FieldOnRay::Active FieldOnRay::active(const Active& from, Real t0, Real t1) const {
  Active kept;
  kept.reserve(from.size());
  for (const std::uint32_t i : from) {
    if (parts_[i].support.begin <= t1 && parts_[i].support.end >= t0) kept.push_back(i);
  }
  return kept;
}

void FieldOnRay::add(Sums& sums, const Part& part, const FieldRange& range) const {
  FieldRange& sum = sums[part.branch];
  // The fields of an unblended blob are positive, and those that are not met are zero, as the sum is at first.
  sum = is_unblended_ ? greater(sum, range) : FieldRange{sum.value + range.value, sum.derivative + range.derivative};
}

/// The value of the greatest of several sums, and the hull of the derivatives of those that may be the greatest.
FieldRange FieldOnRay::total(Sums& sums) const {
  for (const auto& [maximum, has_idle] : maxima_) {
    Interval greatest = has_idle ? Interval(0) : sums[maximum.rivals[0]].value;
    for (const std::uint32_t b : maximum.rivals)
      greatest = {std::max(greatest.lo, sums[b].value.lo), std::max(greatest.hi, sums[b].value.hi)};
    std::optional<Interval> derivative;
    if (has_idle && greatest.lo <= 0) derivative = Interval(0);
    for (const std::uint32_t b : maximum.rivals) {
      if (sums[b].value.hi < greatest.lo) continue;
      derivative = derivative ? hull(*derivative, sums[b].derivative) : sums[b].derivative;
    }
    FieldRange& parent = sums[maximum.parent];
    parent = {parent.value + greatest, parent.derivative + *derivative};
  }
  return {sums[0].value - threshold_, sums[0].derivative};
}

FieldRange FieldOnRay::at(const Active& active, Real t) const {
  sums_.assign(branch_count_, {});
  for (const std::uint32_t i : active) add(sums_, parts_[i], parts_[i].component->at(parts_[i].line, t));
  return total(sums_);
}

FieldRange FieldOnRay::at(const Active& active, Real t, Samples& samples) const {
  samples.clear();
  sums_.assign(branch_count_, {});
  for (const std::uint32_t i : active) {
    samples.push_back(parts_[i].component->point(parts_[i].line, t));
    add(sums_, parts_[i], parts_[i].component->at(samples.back()));
  }
  return total(sums_);
}

FieldOnRay::Piece FieldOnRay::piece(const Active& from, Real t0, Real t1) const {
  Piece piece{t0, t1, active(from, t0, t1), {}, {}};
  for (const std::uint32_t i : piece.active) {
    piece.first.push_back(parts_[i].component->point(parts_[i].line, t0));
    piece.last.push_back(parts_[i].component->point(parts_[i].line, t1));
  }
  return piece;
}

FieldRange FieldOnRay::over(Piece& piece) const {
  const Real t0 = piece.t0, t1 = piece.t1;
  sums_.assign(branch_count_, {});
  firsts_.assign(branch_count_, {});
  lasts_.assign(branch_count_, {});
  std::size_t kept = 0;
  for (std::size_t k = 0; k < piece.active.size(); ++k) {
    const Part& part = parts_[piece.active[k]];
    if (part.support.begin > t1 || part.support.end < t0) continue;
    const FieldRange range = part.component->over(part.line, t0, t1, piece.first[k], piece.last[k]);
    if (range.value.lo == 0 && range.value.hi == 0) continue;
    add(sums_, part, range);
    add(firsts_, part, part.component->at(piece.first[k]));
    add(lasts_, part, part.component->at(piece.last[k]));
    piece.active[kept] = piece.active[k];
    piece.first[kept] = piece.first[k];
    piece.last[kept] = piece.last[k];
    ++kept;
  }
  piece.active.resize(kept);
  piece.first.resize(kept);
  piece.last.resize(kept);
  // A maximum has edges. But the slope between any two of its values lies between slopes of the sums that are the
  // greatest there, so the mean-value form holds for it too.
  FieldRange sum = total(sums_);
  const Interval step(0, (Interval(t1) - Interval(t0)).hi);
  sum.value = common(sum.value, total(firsts_).value + sum.derivative * step);
  sum.value = common(sum.value, total(lasts_).value - sum.derivative * step);
  return sum;
}

FieldRange FieldOnRay::over(const Active& active, Real t0, Real t1) const {
  Piece whole = piece(active, t0, t1);
  return over(whole);
}

FieldOnRay::Magnitude FieldOnRay::magnitude_at(Real t) const {
  const auto middle = [](const Vector<Interval>& v) { return Vector<Real>{v.x.middle(), v.y.middle(), v.z.middle()}; };
  const Vector<Real> direction = middle(ray_.direction), place = middle(ray_.origin) + direction * t;
  const Real speed = sqrt(squared_length(direction));
  Magnitude magnitude;
  for (const Part& part : parts_) {
    const FieldRange range = part.component->at(part.line, t);
    if (range.value.hi == 0 && range.value.lo == 0) continue;
    magnitude.values += range.value.magnitude();
    magnitude.gradients += sqrt(squared_length(part.component->sample(place).gradient)) * speed;
    magnitude.sensitivities += part.component->sensitivity_at(part.line, t);
    ++magnitude.count;
  }
  return magnitude;
}

bool FieldOnRay::stays_within(const Interval& band, Real t0, Real t1) const {
  struct Range {
    Real t0, t1;
  };
  std::vector<Range> open{{t0, t1}};
  const Active everything = all();
  // 10,000 pieces are far more than any stretch with a clear result needs.
  for (int step = 0; !open.empty(); ++step) {
    const Range range = open.back();
    open.pop_back();
    const Active near = active(everything, range.t0, range.t1);
    const Interval values = over(near, range.t0, range.t1).value;
    if (values.lo >= band.lo && values.hi <= band.hi) continue;
    const Real cut = range.t0 + (range.t1 - range.t0) / 2;
    const Interval value = at(near, cut).value;
    const bool is_beyond = value.lo > band.hi || value.hi < band.lo;
    if (step > 10000 || is_beyond || !(range.t0 < cut && cut < range.t1)) return false;
    open.push_back({range.t0, cut});
    open.push_back({cut, range.t1});
  }
  return true;
}

}  // namespace isl::ISL_REFERENCE
