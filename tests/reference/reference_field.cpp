#include "tests/reference/reference_field.h"

#include "base/check.h"

#include <cmath>

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

ReferenceComponent::ReferenceComponent(const scene::Component& component, const ReferenceKernel& kernel,
                                       const scene::Transform& transform)
    : skeleton_(component),
      kernel_(kernel),
      component_from_blob_(transform.inverse),
      strength_(component.strength),
      has_transform_(transform.inverse != scene::Matrix()) {}

FieldSample ReferenceComponent::sample(const Vector<long double>& p) const {
  Vector<Interval> w{p.x, p.y, p.z};
  if (has_transform_) w = transformed_point(w, component_from_blob_);
  w = w - skeleton_.start();
  const Interval v = skeleton_.nearest(w);
  const Vector<Interval> offset = skeleton_.offset(w, v);
  const Interval q = skeleton_.relative(squared_length(offset), v);

  FieldSample sample;
  sample.value = (strength_ * kernel_.value(q)).middle();
  sample.sum_of_values = std::abs(sample.value);
  const Interval slope = strength_ * kernel_.slope(q);
  if (slope.sign() == 0) return sample;
  const Interval scale = Interval(2) * slope / square(skeleton_.radius(v));
  Vector<Interval> gradient = offset * scale;
  // A gradient goes back by the transpose of the map into the component's space.
  if (has_transform_) gradient = transformed_vector(gradient, component_from_blob_.transposed());
  sample.gradient = {gradient.x.middle(), gradient.y.middle(), gradient.z.middle()};
  return sample;
}

Interval ReferenceComponent::range(const Vector<Interval>& box) const {
  const Vector<Interval> local = has_transform_ ? transformed_point(box, component_from_blob_) : box;
  const Vector<Interval> w = local - skeleton_.start();
  const Interval v = skeleton_.nearest(w);
  return strength_ * kernel_.value(skeleton_.relative(squared_length(skeleton_.offset(w, v)), v));
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob) : threshold_(blob.threshold) {
  ISL_CHECK(blob.threshold > 0, "threshold {}", blob.threshold);
  const std::vector<ReferenceKernel> kernels(database.kernels.begin(), database.kernels.end());
  components_.reserve(blob.components.size());
  for (const scene::Component& component : blob.components) {
    components_.emplace_back(component, kernels[index(component.kernel)], transform_of(database, component));
  }
}

FieldSample ReferenceField::sample(const Vector<long double>& p) const {
  FieldSample sum;
  for (const ReferenceComponent& component : components_) {
    const FieldSample part = component.sample(p);
    sum.value += part.value;
    sum.sum_of_values += part.sum_of_values;
    sum.gradient = sum.gradient + part.gradient;
  }
  sum.value -= threshold_;
  return sum;
}

}  // namespace isl::reference
