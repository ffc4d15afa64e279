#include "renderer/reference/reference_field.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace isl::reference {
namespace {

Interval row_times_column(const Vector<Interval>& v, const scene::Matrix& m, int column) {
  return v.x * Interval(m[0][column]) + v.y * Interval(m[1][column]) + v.z * Interval(m[2][column]);
}

const scene::Transform& transform_of(const scene::Database& database, const scene::Component& component) {
  static const scene::Transform kIdentityTransform;
  return component.transform == scene::kIdentity ? kIdentityTransform : database.transforms[index(component.transform)];
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
    : skeleton_(component, corners),
      kernel_(kernel.profile),
      component_from_blob_(transform.inverse),
      strength_(component.strength),
      has_transform_(transform.inverse != scene::Matrix()) {
  if (kernel.record.mode == scene::FieldMode::convolution) convolution_.emplace(component, kernel.record);
}

FieldSample ReferenceComponent::sample(const Vector<long double>& p) const {
  Vector<Interval> local{p.x, p.y, p.z};
  if (has_transform_) local = transformed_point(local, component_from_blob_);

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
  sample.sum_of_values = std::abs(sample.value);
  // A gradient is mapped back by the transpose of the map into the component's space.
  if (has_transform_) gradient = transformed_vector(gradient, component_from_blob_.transposed());
  sample.gradient = {gradient.x.middle(), gradient.y.middle(), gradient.z.middle()};
  return sample;
}

Interval ReferenceComponent::range(const Vector<Interval>& box) const {
  const Vector<Interval> local = has_transform_ ? transformed_point(box, component_from_blob_) : box;
  return strength_ * (convolution_ ? convolution_->range(local) : kernel_.value(skeleton_.at(local).q));
}

FieldRange ReferenceComponent::field_of(const DistanceOnLine& distance) const {
  return strengthened({kernel_.value(distance.q), kernel_.slope(distance.q) * distance.slope});
}

FieldRange ReferenceComponent::at(const Line& line, long double t) const {
  return convolution_ ? strengthened(convolution_->at(line, t)) : field_of(skeleton_.at(line, t));
}

ReferenceComponent::Stretched ReferenceComponent::over(const Line& line, long double t0, long double t1) const {
  if (convolution_) {
    const FieldRange first = convolution_->at(line, t0), last = convolution_->at(line, t1);
    return {strengthened(convolution_->over(line, t0, t1, first, last)), strengthened(first), strengthened(last)};
  }
  const DistanceOnLine first = skeleton_.at(line, t0), last = skeleton_.at(line, t1);
  return {field_of(skeleton_.over({line, t0, t1, first, last})), field_of(first), field_of(last)};
}

long double ReferenceComponent::sensitivity_at(const Line& line, long double t) const {
  if (convolution_) return strength_.magnitude() * convolution_->at(line.at(t)).sensitivity;
  const Interval q = skeleton_.at(line, t).q;
  return (strength_ * kernel_.slope(q) * q).magnitude();
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob) : threshold_(blob.threshold) {
  ISL_CHECK(blob.threshold > 0, "threshold {}", blob.threshold);
  std::vector<std::uint32_t> all(blob.components.size());
  std::iota(all.begin(), all.end(), 0u);
  add(database, blob, all);
  branch_of_.assign(blob.branch_of.begin(), blob.branch_of.end());
  branches_.assign(blob.branches.begin(), blob.branches.end());
  if (branches_.empty()) branches_.push_back({0, 0});
  branch_of_.resize(components_.size());
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob,
                               std::span<const std::uint32_t> numbers)
    : branch_of_(numbers.size()), branches_{{0, 0}}, threshold_(blob.threshold) {
  add(database, blob, numbers);
}

void ReferenceField::add(const scene::Database& database, const scene::Blob& blob,
                         std::span<const std::uint32_t> numbers) {
  std::map<scene::KernelId, KernelInUse> kernels;
  components_.reserve(numbers.size());
  for (const std::uint32_t number : numbers) {
    const scene::Component& component = blob.components[number];
    const auto kernel = kernels.try_emplace(component.kernel, database.kernels[index(component.kernel)]).first;
    components_.emplace_back(component, kernel->second, transform_of(database, component),
                             std::span(blob.corners.begin(), blob.corners.size()));
  }
}

FieldSample ReferenceField::sample(const Vector<long double>& p) const {
  std::vector<FieldSample> sums(branches_.size());
  const auto add = [](FieldSample& sum, const FieldSample& part) {
    sum.value += part.value;
    sum.sum_of_values += part.sum_of_values;
    sum.gradient = sum.gradient + part.gradient;
  };
  for (std::size_t i = 0; i < components_.size(); ++i) add(sums[branch_of_[i]], components_[i].sample(p));
  fold_maxima(branches_, [&](std::uint32_t parent, std::span<const std::uint32_t> rivals) {
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return sums[a].value < sums[b].value; };
    add(sums[parent], sums[*std::ranges::max_element(rivals, less)]);
  });
  sums[0].value -= threshold_;
  return sums[0];
}

}  // namespace isl::reference
