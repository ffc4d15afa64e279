#include "renderer/reference/reference_ray.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace isl::ISL_REFERENCE {
namespace {

/// Where a line can be inside a ball about `centre`. Nothing if it passes at a distance of |w × d|/|d| that is greater.
std::optional<ReferenceSkeleton::Stretch> within_ball(const Line& line, const Vector<Real>& centre, Real radius) {
  const Vector<Interval> w = line.origin - Vector<Interval>{centre.x, centre.y, centre.z}, &d = line.direction;
  const Interval speed2 = squared_length(d), passing2 = squared_length(cross(w, d)) / speed2;
  const Interval chord2 = square(Interval(radius)) - passing2;
  if (chord2.hi() < 0) return std::nullopt;
  const Interval nearest = -dot(w, d) / speed2, half = square_root(Interval(chord2.hi()) / speed2);
  return ReferenceSkeleton::Stretch{(nearest - half).lo(), (nearest + half).hi()};
}

/// The greatest of several functions: where each of several may be it, the slope is between theirs, and jumps.
Jet greatest(std::span<const Jet*> rivals) {
  Interval value = rivals[0]->value;
  for (const Jet* one : rivals)
    value = Interval(std::max(value.lo(), one->value.lo()), std::max(value.hi(), one->value.hi()));
  std::optional<Jet> result;
  for (const Jet* one : rivals) {
    if (one->value.hi() < value.lo()) continue;
    result = result ? Jet{value, hull(result->slope, one->slope), Interval::around(0, kUnbounded)} : *one;
  }
  return *result;
}

}  // namespace

FieldOnRay::FieldOnRay(const ReferenceField& field, const Line& ray) : ray_(ray), threshold_(field.threshold()) {
  std::vector<std::uint32_t> numbers;
  field.components_along(RoughLine(ray), numbers);
  for (const std::uint32_t i : numbers) {
    const ReferenceComponent& component = field.components()[i];
    Part part{&component, field.branch_of(i), component.local(ray), {-kUnbounded, kUnbounded}};
    const ReferenceSkeleton& skeleton = component.skeleton();
    const Real border = component.kernel().support().hi();
    std::optional<ReferenceSkeleton::Stretch> change = skeleton.change_on(part.line, sqrt(border));
    if (!change) {
      change = within_ball(part.line, skeleton.bound_centre(), skeleton.reach(border));
      if (!change) continue;
      part.support = *change;
    }
    begin_ = parts_.empty() ? change->begin : std::min(begin_, change->begin);
    end_ = parts_.empty() ? change->end : std::max(end_, change->end);
    parts_.push_back(part);
  }
  if (field.is_unblended()) {
    // Every component is the only one of its branch. What the ray does not meet is zero, as it is far away from all.
    MaximumHere all{{0, {}}, true};
    for (Part& part : parts_) all.maximum.rivals.push_back(part.branch = static_cast<std::uint32_t>(branch_count_++));
    if (!parts_.empty()) maxima_.push_back(std::move(all));
  } else if (field.branch_count() > 1) {
    find_maxima(field);
  }
}

/// Numbers the branches that matter on this ray anew, since a blob may have thousands.
void FieldOnRay::find_maxima(const ReferenceField& field) {
  std::vector<std::uint32_t> here(field.branch_count(), scene::kNone);
  here[0] = 0;
  const auto meet = [&](std::uint32_t branch) {
    if (here[branch] == scene::kNone) here[branch] = static_cast<std::uint32_t>(branch_count_++);
    return here[branch];
  };
  for (Part& part : parts_) part.branch = meet(part.branch);
  for (const Maximum& all : field.maxima()) {  // inner ones first, so that their parents are known to matter
    MaximumHere maximum{{0, {}}, false};
    for (const std::uint32_t rival : all.rivals) {
      if (here[rival] == scene::kNone) {
        maximum.has_idle = true;
      } else {
        maximum.maximum.rivals.push_back(here[rival]);
      }
    }
    if (maximum.maximum.rivals.empty()) continue;
    maximum.maximum.parent = meet(all.parent);
    maxima_.push_back(std::move(maximum));
  }
}

FieldOnRay::Active FieldOnRay::all() const {
  Active numbers(parts_.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

Jet FieldOnRay::total(std::vector<Jet>& sums) const {
  static const Jet kIdle;
  std::vector<const Jet*> rivals;
  for (const auto& [maximum, has_idle] : maxima_) {
    rivals.clear();
    if (has_idle) rivals.push_back(&kIdle);
    for (const std::uint32_t branch : maximum.rivals) rivals.push_back(&sums[branch]);
    sums[maximum.parent] += greatest(rivals);
  }
  return sums[0] - threshold_;
}

Ends FieldOnRay::total(std::vector<Ends>& sums) const {
  for (const auto& [maximum, has_idle] : maxima_) {
    Ends greatest = has_idle ? Ends() : sums[maximum.rivals.front()];
    for (const std::uint32_t branch : maximum.rivals)
      greatest = {std::max(greatest.low, sums[branch].low), std::max(greatest.high, sums[branch].high)};
    sums[maximum.parent] = sums[maximum.parent] + greatest;
  }
  return sums[0] + Ends{-threshold_.hi(), -threshold_.lo()};
}

Jet FieldOnRay::at(const Active& active, Real t) const {
  middles_.assign(branch_count_, {});
  for (const std::uint32_t i : active) {
    const Part& part = parts_[i];
    if (part.support.begin > t || part.support.end < t) continue;
    middles_[part.branch] += part.component->at(part.line, t);
  }
  return total(middles_);
}

JetPair FieldOnRay::on(Active& active, const LineStretch& stretch) const {
  middles_.assign(branch_count_, {});
  overs_.assign(branch_count_, {});
  ends_.assign(branch_count_, {});
  const Interval all = stretch.all();
  std::erase_if(active, [&](std::uint32_t i) {
    const Part& part = parts_[i];
    if (part.support.begin > all.hi() || part.support.end < all.lo()) return true;
    const JetPair f = part.component->on(part.line, stretch);
    if (f.over.value.magnitude() == 0) return true;
    middles_[part.branch] += f.middle;
    overs_[part.branch] += f.over;
    ends_[part.branch] = ends_[part.branch] + f.ends;
    return false;
  });
  if (!maxima_.empty()) {
    for (std::size_t b = 0; b < branch_count_; ++b) overs_[b] = sharpened(overs_[b], middles_[b], stretch.reach);
  }
  const Jet middle = total(middles_);
  return {middle, sharpened(total(overs_), middle, stretch.reach), total(ends_)};
}

Jet FieldOnRay::over(Real t0, Real t1) const {
  Active active = all();
  return on(active, stretch_between(t0, t1)).over;
}

FieldOnRay::Magnitude FieldOnRay::magnitude_at(Real t) const {
  const Vector<Jet> place = ray_.at(t);
  const Vector<Real> p{place.x.value.middle(), place.y.value.middle(), place.z.value.middle()};
  const Real speed = square_root(squared_length(ray_.direction)).middle();
  Magnitude magnitude;
  for (const Part& part : parts_) {
    const Interval value = part.component->at(part.line, t).value;
    if (value.magnitude() == 0) continue;
    magnitude.values += value.magnitude();
    magnitude.gradients += sqrt(squared_length(part.component->sample(p).gradient)) * speed;
    magnitude.sensitivities += part.component->sensitivity_at(part.line, t);
    ++magnitude.count;
  }
  return magnitude;
}

bool FieldOnRay::stays_within(const Band& band, Real t0, Real t1) const {
  struct Range {
    Real t0, t1;
    Active active;
  };
  std::vector<Range> open{{t0, t1, all()}};
  // 10,000 pieces are far more than any stretch with a clear result needs.
  for (int step = 0; !open.empty(); ++step) {
    Range range = std::move(open.back());
    open.pop_back();
    const JetPair f = on(range.active, stretch_between(range.t0, range.t1));
    const Interval& values = f.over.value;
    if (values.lo() >= band.low && values.hi() <= band.high) continue;
    const bool is_beyond = f.middle.value.lo() > band.high || f.middle.value.hi() < band.low;
    const Real cut = range.t0 + (range.t1 - range.t0) / 2;
    if (step > 10000 || is_beyond || !(range.t0 < cut && cut < range.t1)) return false;
    open.push_back({range.t0, cut, range.active});
    open.push_back({cut, range.t1, std::move(range.active)});
  }
  return true;
}

}  // namespace isl::ISL_REFERENCE
