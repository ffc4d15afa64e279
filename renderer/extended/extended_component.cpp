#include "renderer/extended/extended_component.h"

namespace isl::ISL_EXTENDED {
namespace {

Interval row_times_column(const Vector<Interval>& v, const scene::Matrix& m, int column) {
  return v.x * Interval(m[0][column]) + v.y * Interval(m[1][column]) + v.z * Interval(m[2][column]);
}

}  // namespace

Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m) {
  return {row_times_column(v, m, 0), row_times_column(v, m, 1), row_times_column(v, m, 2)};
}

Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m) {
  return transformed_vector(p, m) + Vector<Interval>{Interval(m[3][0]), Interval(m[3][1]), Interval(m[3][2])};
}

ExtendedComponent::ExtendedComponent(const scene::Component& component, const scene::Kernel& kernel,
                                     const ExtendedKernel& profile, const scene::Transform& transform,
                                     std::span<const scene::Vec3> corners)
    : skeleton_(component, corners),
      kernel_(profile),
      component_from_blob_(transform.inverse != scene::Matrix() ? &transform.inverse : nullptr),
      strength_(component.strength) {
  if (kernel.mode == scene::FieldMode::convolution)
    convolution_ = std::make_shared<const ExtendedConvolution>(component, kernel);
}

Line ExtendedComponent::enter(const Line& line) const {
  if (component_from_blob_ == nullptr) return line;
  return {transformed_point(line.origin, *component_from_blob_),
          transformed_vector(line.direction, *component_from_blob_)};
}

FieldRange ExtendedComponent::field_of(const DistanceOnLine& distance) const {
  return {kernel_.value(distance.q), kernel_.slope(distance.q) * distance.slope};
}

ExtendedComponent::AtPoint ExtendedComponent::point(const Line& line, Real t) const {
  if (convolution_) return {{}, convolution_->at(line, t)};
  const DistanceOnLine distance = skeleton_.at(line, t);
  return {distance, field_of(distance)};
}

FieldRange ExtendedComponent::over(const Line& line, Real t0, Real t1, const AtPoint& first,
                                   const AtPoint& last) const {
  return strengthened(convolution_ ? convolution_->over(line, t0, t1, first.field, last.field)
                                   : field_of(skeleton_.over({line, t0, t1, first.distance, last.distance})));
}

}  // namespace isl::ISL_EXTENDED
