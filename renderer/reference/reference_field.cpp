#include "renderer/reference/reference_field.h"

#include "base/check.h"

#include <algorithm>
#include <map>

namespace isl::ISL_REFERENCE {
namespace {

Interval row_times_column(const Vector<Interval>& v, const scene::Matrix& m, int column) {
  return v.x * Interval(m[0][column]) + v.y * Interval(m[1][column]) + v.z * Interval(m[2][column]);
}

const scene::Transform& transform_of(const scene::Database& database, const scene::Component& component) {
  static const scene::Transform kIdentityTransform;
  return component.transform == scene::kIdentity ? kIdentityTransform : database.transforms[index(component.transform)];
}

/// Inner maxima before outer ones: a branch has a greater number than its parent, so the maximum that begins last
/// contains no other.
std::vector<Maximum> maxima_of(std::span<const scene::Branch> branches) {
  std::vector<Maximum> maxima;
  std::vector<std::uint32_t> place(
      branches.size());  // of each maximum, counted from 1, by the number of its first branch
  for (std::uint32_t b = 1; b < branches.size(); ++b) {
    std::uint32_t& at = place[branches[b].maximum];
    if (at == 0) {
      maxima.push_back({branches[b].parent, {}});
      at = static_cast<std::uint32_t>(maxima.size());
    }
    maxima[at - 1].rivals.push_back(b);
  }
  std::ranges::reverse(maxima);
  return maxima;
}

}  // namespace

Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m) {
  return {row_times_column(v, m, 0), row_times_column(v, m, 1), row_times_column(v, m, 2)};
}

Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m) {
  return transformed_vector(p, m) + Vector<Interval>{Interval(m[3][0]), Interval(m[3][1]), Interval(m[3][2])};
}

ReferenceComponent::ReferenceComponent(const scene::Component& component, const KernelInUse& kernel,
                                       const scene::Transform& transform, std::span<const scene::Vec3> corners)
    : skeleton_(component, corners), kernel_(kernel.profile), strength_(component.strength) {
  if (transform.inverse != scene::Matrix()) {
    component_from_blob_ = std::make_shared<const scene::Matrix>(transform.inverse);
  }
  if (kernel.record.mode == scene::FieldMode::convolution) {
    convolution_ = std::make_shared<const ReferenceConvolution>(component, kernel.record);
  }
}

Ball ReferenceComponent::support() const {
  const Real reach = skeleton_.reach(kernel_.support().hi);
  return component_from_blob_ ? ball_before(skeleton_.bound_centre(), reach, *component_from_blob_)
                              : rounded_ball(skeleton_.bound_centre(), reach);
}

FieldSample ReferenceComponent::sample(const Vector<Real>& p) const {
  Vector<Interval> local{p.x, p.y, p.z};
  if (component_from_blob_) local = transformed_point(local, *component_from_blob_);

  FieldSample sample;
  Vector<Interval> gradient;
  if (convolution_) {
    const ReferenceConvolution::Sample convolved = convolution_->at(local);
    sample.value = (strength_ * convolved.value).middle();
    gradient = convolved.gradient * strength_;
  } else {
    const RelativeDistance distance = skeleton_.at(local);
    sample.value = (strength_ * kernel_.value(distance.q)).middle();
    const Interval slope = strength_ * kernel_.slope(distance.q);
    if (slope.sign() != 0) gradient = distance.gradient * slope;
  }
  sample.sum_of_values = abs(sample.value);
  // A gradient is mapped back by the transpose of the map into the component's space.
  if (component_from_blob_) gradient = transformed_vector(gradient, component_from_blob_->transposed());
  sample.gradient = {gradient.x.middle(), gradient.y.middle(), gradient.z.middle()};
  return sample;
}

Interval ReferenceComponent::range(const Vector<Interval>& box) const {
  const Vector<Interval> local = component_from_blob_ ? transformed_point(box, *component_from_blob_) : box;
  return strength_ * (convolution_ ? convolution_->range(local) : kernel_.value(skeleton_.at(local).q));
}

FieldRange ReferenceComponent::field_of(const DistanceOnLine& distance) const {
  return {kernel_.value(distance.q), kernel_.slope(distance.q) * distance.slope};
}

ReferenceComponent::AtPoint ReferenceComponent::point(const Line& line, Real t) const {
  if (convolution_) return {{}, convolution_->at(line, t)};
  const DistanceOnLine distance = skeleton_.at(line, t);
  return {distance, field_of(distance)};
}

FieldRange ReferenceComponent::over(const Line& line, Real t0, Real t1, const AtPoint& first,
                                    const AtPoint& last) const {
  return strengthened(convolution_ ? convolution_->over(line, t0, t1, first.field, last.field)
                                   : field_of(skeleton_.over({line, t0, t1, first.distance, last.distance})));
}

Real ReferenceComponent::sensitivity_at(const Line& line, Real t) const {
  if (convolution_) return strength_.magnitude() * convolution_->at(line.at(t)).sensitivity;
  const Interval q = skeleton_.at(line, t).q;
  return (strength_ * kernel_.slope(q) * q).magnitude();
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob, Drawn drawn)
    : threshold_(blob.threshold), is_unblended_(drawn == Drawn::unblended || blob.is_unblended) {
  ISL_CHECK(blob.threshold > 0, "threshold {}", blob.threshold);
  std::vector<std::uint32_t> numbers;
  numbers.reserve(blob.components.size());
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    if (!is_unblended_ || blob.components[i].strength > 0) numbers.push_back(i);
  }
  add(database, blob, numbers);
  if (is_unblended_ || blob.branches.empty()) return;
  branch_of_.assign(blob.branch_of.begin(), blob.branch_of.end());
  maxima_ = maxima_of(std::span(blob.branches.begin(), blob.branches.size()));
  branch_count_ = blob.branches.size();
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob,
                               std::span<const std::uint32_t> numbers)
    : threshold_(blob.threshold), is_unblended_(false) {
  add(database, blob, numbers);
}

void ReferenceField::add(const scene::Database& database, const scene::Blob& blob,
                         std::span<const std::uint32_t> numbers) {
  std::map<scene::KernelId, KernelInUse> kernels;
  std::vector<Ball> supports;
  components_.reserve(numbers.size());
  supports.reserve(numbers.size());
  for (const std::uint32_t number : numbers) {
    const scene::Component& component = blob.components[number];
    const auto kernel = kernels.try_emplace(component.kernel, database.kernels[index(component.kernel)]).first;
    components_.emplace_back(component, kernel->second, transform_of(database, component),
                             std::span(blob.corners.begin(), blob.corners.size()));
    supports.push_back(components_.back().support());
  }
  supports_ = BallTree(supports);
  branch_of_.assign(numbers.size(), 0);
}

FieldSample ReferenceField::sample(const Vector<Real>& p) const {
  std::vector<FieldSample> sums(branch_count_);
  const auto add = [](FieldSample& sum, const FieldSample& part) {
    sum.value += part.value;
    sum.sum_of_values += part.sum_of_values;
    sum.gradient = sum.gradient + part.gradient;
  };
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const FieldSample part = components_[i].sample(p);
    if (!is_unblended_) {
      add(sums[branch_of_[i]], part);
    } else if (part.value > sums[0].value) {
      sums[0] = part;
    }
  }
  for (const Maximum& maximum : maxima_) {
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return sums[a].value < sums[b].value; };
    add(sums[maximum.parent], sums[*std::ranges::max_element(maximum.rivals, less)]);
  }
  sums[0].value -= threshold_;
  return sums[0];
}

}  // namespace isl::ISL_REFERENCE
