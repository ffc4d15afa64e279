// F(p) = Σ strength·φ(q) + Σ max(sums of branches) − threshold of a scene::Blob, straight from its definition: every
// component; an unblended blob is the greatest of its fields. It judges the product's fields, with
// which it shares only the records of the database.
#pragma once

#include "renderer/reference/ball_tree.h"
#include "renderer/reference/interval.h"
#include "renderer/reference/reference_convolution.h"
#include "renderer/reference/reference_kernel.h"
#include "renderer/reference/reference_skeleton.h"
#include "renderer/scene/database.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace isl::ISL_REFERENCE {

/// Value, gradient (in units of value per length) and the size of the summed terms, from which rounding errors are
/// judged.
struct FieldSample {
  Real value = 0;
  Vector<Real> gradient{};
  Real sum_of_values = 0;  ///< Σ|fᵢ|
};

/// `p·M` and `v·M` for an affine M with row vectors (the database's convention), without rounding M.
[[nodiscard]] Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m);
[[nodiscard]] Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m);

/// A kernel with its record.
struct KernelInUse {
  explicit KernelInUse(const scene::Kernel& of) : record(of), profile(of) {}

  scene::Kernel record;
  ReferenceKernel profile;
};

/// One component with everything that it refers to.
class ReferenceComponent {
 public:
  /// `component`'s own references are not followed: `kernel` and `transform` are the records that they refer to.
  /// `corners` are the blob's.
  ReferenceComponent(const scene::Component& component, const KernelInUse& kernel, const scene::Transform& transform,
                     std::span<const scene::Vec3> corners);

  /// f and ∇f at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<Real>& p) const;
  /// Encloses f over a box in the blob's space.
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

  // These are on a line in the component's own space.
  [[nodiscard]] FieldRange at(const Line& line, Real t) const { return at(point(line, t)); }
  /// With strength 1.
  struct AtPoint {
    DistanceOnLine distance;  ///< unused by a convolution
    FieldRange field;
  };
  [[nodiscard]] AtPoint point(const Line& line, Real t) const;
  [[nodiscard]] FieldRange at(const AtPoint& point) const { return strengthened(point.field); }
  /// The field over a stretch, from its ends.
  [[nodiscard]] FieldRange over(const Line& line, Real t0, Real t1, const AtPoint& first, const AtPoint& last) const;
  /// The effect at t of a relative error of q, or of all squared distances to a curve's points.
  [[nodiscard]] Real sensitivity_at(const Line& line, Real t) const;

  [[nodiscard]] const ReferenceSkeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const ReferenceKernel& kernel() const { return kernel_; }
  /// Null if the component's space is the blob's.
  [[nodiscard]] const scene::Matrix* component_from_blob() const { return component_from_blob_.get(); }
  /// Outside this ball in the blob's space the field is zero.
  [[nodiscard]] Ball support() const;

 private:
  [[nodiscard]] FieldRange field_of(const DistanceOnLine& distance) const;
  [[nodiscard]] FieldRange strengthened(const FieldRange& f) const {
    return {strength_ * f.value, strength_ * f.derivative};
  }

  ReferenceSkeleton skeleton_;
  ReferenceKernel kernel_;
  std::shared_ptr<const ReferenceConvolution> convolution_;  ///< set if the kernel is integrated along the skeleton
  /// The inverse that the database keeps, because it defines the field.
  std::shared_ptr<const scene::Matrix> component_from_blob_;
  Interval strength_;
};

/// The greatest of the rivals' sums is a term of the parent's sum. All are branches.
struct Maximum {
  std::uint32_t parent;
  std::vector<std::uint32_t> rivals;
};

class ReferenceField {
 public:
  /// `unblended`: even if the blob's record does not say so.
  enum class Drawn : std::uint8_t { as_recorded, unblended };
  ReferenceField(const scene::Database& database, const scene::Blob& blob, Drawn drawn = Drawn::as_recorded);
  /// The plain sum of some of the blob's components, minus its threshold; `numbers` are indices of components.
  ReferenceField(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers);

  /// F and ∇F at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<Real>& p) const;
  [[nodiscard]] Real value(const Vector<Real>& p) const { return sample(p).value; }

  [[nodiscard]] const std::vector<ReferenceComponent>& components() const { return components_; }
  /// Branch 0 is the blob's sum. It is the only one if the blob has no maxima.
  [[nodiscard]] std::size_t branch_count() const { return branch_count_; }
  /// The branch of each component.
  [[nodiscard]] std::uint32_t branch_of(std::size_t component) const { return branch_of_[component]; }
  /// Inner maxima come before outer ones.
  [[nodiscard]] const std::vector<Maximum>& maxima() const { return maxima_; }
  /// The blob is the greatest of its components' fields, and all of these are positive.
  [[nodiscard]] bool is_unblended() const { return is_unblended_; }
  /// Outside this ball all fields are zero; its radius is −1 if there are none.
  [[nodiscard]] Ball bounds() const { return supports_.bounds(); }
  /// Appends the numbers of the components whose support the line may meet.
  void components_along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const {
    supports_.along(line, numbers);
  }
  [[nodiscard]] Real threshold() const { return threshold_; }

 private:
  void add(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers);

  std::vector<ReferenceComponent> components_;
  std::vector<std::uint32_t> branch_of_;
  std::vector<Maximum> maxima_;
  BallTree supports_;
  std::size_t branch_count_ = 1;
  Real threshold_;
  bool is_unblended_;
};

}  // namespace isl::ISL_REFERENCE
