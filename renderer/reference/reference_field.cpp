#include "renderer/reference/reference_field.h"

#include "base/check.h"

#include <algorithm>
#include <map>

namespace isl::ISL_REFERENCE {
namespace {

const scene::Transform& transform_of(const scene::Database& database, const scene::Component& component) {
  static const scene::Transform kIdentityTransform;
  return component.transform == scene::kIdentity ? kIdentityTransform : database.transforms[index(component.transform)];
}

/// A branch has a greater number than its parent, so the maximum that begins last contains no other.
std::vector<Maximum> maxima_of(std::span<const scene::Branch> branches) {
  std::map<std::uint32_t, Maximum, std::greater<>> maxima;  // by the number of their first branch
  for (std::uint32_t b = 1; b < branches.size(); ++b) {
    Maximum& maximum = maxima[branches[b].maximum];
    maximum.parent = branches[b].parent;
    maximum.rivals.push_back(b);
  }
  std::vector<Maximum> inner_first;
  for (auto& [first, maximum] : maxima) inner_first.push_back(std::move(maximum));
  return inner_first;
}

}  // namespace

Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m) {
  const auto coordinate = [&](int column) {
    return v.x * Interval(m[0][column]) + v.y * Interval(m[1][column]) + v.z * Interval(m[2][column]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m) {
  return transformed_vector(p, m) + Vector<Interval>{Interval(m[3][0]), Interval(m[3][1]), Interval(m[3][2])};
}

ReferenceComponent::ReferenceComponent(const scene::Component& component, std::shared_ptr<const KernelInUse> kernel,
                                       const scene::Transform& transform, std::span<const scene::Vec3> corners)
    : skeleton_(component, corners), kernel_(std::move(kernel)), strength_(component.strength) {
  if (transform.inverse != scene::Matrix())
    component_from_blob_ = std::make_shared<const scene::Matrix>(transform.inverse);
  if (kernel_->record.mode == scene::FieldMode::convolution)
    convolution_ = std::make_shared<const ReferenceConvolution>(component, kernel_->record);
}

Box ReferenceComponent::support() const {
  const Real reach = skeleton_.reach(kernel().support().hi());
  return component_from_blob_ ? box_before(skeleton_.bound_centre(), reach, *component_from_blob_)
                              : box_around(skeleton_.bound_centre(), reach);
}

Line ReferenceComponent::local(const Line& line) const {
  if (!component_from_blob_) return line;
  return {transformed_point(line.origin, *component_from_blob_),
          transformed_vector(line.direction, *component_from_blob_)};
}

Jet ReferenceComponent::at(const Line& line, Real t) const {
  const Vector<Jet> p = line.at(t);
  return (convolution_ ? convolution_->at(p) : kernel().of(skeleton_.of(p))) * strength_;
}

JetPair ReferenceComponent::on(const Line& line, const LineStretch& stretch) const {
  const Vector<Jet> place = line.at(stretch.middle), places = line.at(stretch.all());
  if (convolution_) {
    const ReferenceConvolution::Bounds bounds = convolution_->over(places);
    if (bounds.jet.value.magnitude() == 0) return {};
    return scaled(convolution_->at(place), bounds.jet, bounds.least);
  }
  const auto is_outside = [&](const Jet& q) { return q.value.lo() >= kernel().support().hi(); };
  const Jet all = skeleton_.of(places);
  if (is_outside(all)) return {};
  const Jet middle = skeleton_.of(place);
  Jet q = sharpened(all, middle, stretch.reach);
  if (is_outside(q)) return {};
  q = between(q, skeleton_.of(line.at(stretch.first())), skeleton_.of(line.at(stretch.last())));
  if (is_outside(q)) return {};
  const Jet over = kernel().of(q);
  return scaled(kernel().of(middle), over, is_narrow(over.value) ? over.value.lo() : kernel().least(q.value));
}

JetPair ReferenceComponent::scaled(const Jet& middle, const Jet& over, Real least) const {
  const Jet strong = over * strength_;
  const Interval near = Interval(least) * strength_;
  const bool is_negative = strength_.sign() < 0;
  return {middle * strength_,
          strong,
          {is_negative ? strong.value.lo() : near.lo(), is_negative ? near.hi() : strong.value.hi()}};
}

FieldSample ReferenceComponent::sample(const Vector<Real>& p) const {
  const Vector<Interval> place{p.x, p.y, p.z};
  const auto along = [&](const Vector<Interval>& direction) { return at(local({place, direction}), 0); };
  const Jet x = along({1, 0, 0}), y = along({0, 1, 0}), z = along({0, 0, 1});
  return {x.value.middle(), {x.slope.middle(), y.slope.middle(), z.slope.middle()}, abs(x.value.middle())};
}

Interval ReferenceComponent::range(const Vector<Interval>& box) const {
  // The box is what a line of no speed meets, but where it is at t = 0.
  const Vector<Interval> own = local({box, {}}).origin;
  const Vector<Jet> places{{own.x, 0, 0}, {own.y, 0, 0}, {own.z, 0, 0}};
  if (!convolution_) return kernel().of(skeleton_.of(places)).value * strength_;
  // From the middle of the box the field changes no faster than along the line that it is steepest on.
  const auto half = [](const Interval& x) { return Interval(x.radius()); };
  const Vector<Interval> to_corner{half(own.x), half(own.y), half(own.z)};
  const Interval reach = square_root(squared_length(to_corner));
  const Vector<Jet> spread{{own.x, reach, 0}, {own.y, 0, 0}, {own.z, 0, 0}};
  const Jet over = convolution_->over(spread).jet;
  const Vector<Jet> middle{{own.x.middle(), 0, 0}, {own.y.middle(), 0, 0}, {own.z.middle(), 0, 0}};
  return common(over.value, convolution_->at(middle).value + over.slope) * strength_;
}

Real ReferenceComponent::sensitivity_at(const Line& line, Real t) const {
  const Vector<Jet> p = line.at(t);
  if (convolution_) return strength_.magnitude() * convolution_->sensitivity(p);
  const Interval q = skeleton_.of(p).value;
  return (strength_ * kernel().over(q).slope * q).magnitude();
}

ReferenceField::ReferenceField(const scene::Database& database, const scene::Blob& blob, Drawn drawn)
    : threshold_(blob.threshold), is_unblended_(drawn == Drawn::unblended || blob.is_unblended) {
  std::map<scene::KernelId, std::shared_ptr<const KernelInUse>> kernels;
  std::vector<Box> supports;
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    const scene::Component& component = blob.components[i];
    if (is_unblended_ && !(component.strength > 0)) continue;
    std::shared_ptr<const KernelInUse>& kernel = kernels[component.kernel];
    if (!kernel) kernel = std::make_shared<const KernelInUse>(database.kernels[index(component.kernel)]);
    components_.emplace_back(component, kernel, transform_of(database, component),
                             std::span(blob.corners.begin(), blob.corners.size()));
    supports.push_back(components_.back().support());
  }
  supports_ = BoxTree(supports);
  if (is_unblended_ || blob.branches.empty()) {
    branch_of_.assign(components_.size(), 0);
    return;
  }
  branch_of_.assign(blob.branch_of.begin(), blob.branch_of.end());
  maxima_ = maxima_of(std::span(blob.branches.begin(), blob.branches.size()));
  branch_count_ = blob.branches.size();
}

FieldSample ReferenceField::sample(const Vector<Real>& p) const {
  std::vector<FieldSample> sums(branch_count_);
  const auto add = [](FieldSample& sum, const FieldSample& part) {
    sum = {sum.value + part.value, sum.gradient + part.gradient, sum.sum_of_values + part.sum_of_values};
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
    const auto value = [&](std::uint32_t branch) { return sums[branch].value; };
    add(sums[maximum.parent], sums[*std::ranges::max_element(maximum.rivals, {}, value)]);
  }
  sums[0].value -= threshold_;
  return sums[0];
}

}  // namespace isl::ISL_REFERENCE
