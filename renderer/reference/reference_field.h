// F(p) = Σ strength·φ(q) + Σ max(sums of branches) − threshold of a scene::Blob as docs/language.md defines it: every
// component; an unblended blob is the greatest of its fields. It judges the product's fields, with which it shares only
// the records of the database.
#pragma once

#include "renderer/reference/box_tree.h"
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

/// A stretch of a line: all t not farther than `reach` from the middle, or one place if that is 0.
struct LineStretch {
  Real middle;
  Size reach = 0;

  [[nodiscard]] Interval all() const { return Interval::around(middle, reach); }
  /// The ends, which need not be numbers.
  [[nodiscard]] Interval first() const { return Interval(middle) - Interval(reach); }
  [[nodiscard]] Interval last() const { return Interval(middle) + Interval(reach); }
};

/// No value is below or above. An interval from 1 to e⁵⁰⁰, kept by its middle, has lost the digits of the end that is
/// nearer to 0; sums of ends keep them.
struct Ends {
  Real low = 0, high = 0;

  /// +1 or −1 if every value has that sign, else 0.
  [[nodiscard]] int sign() const { return low > 0 ? 1 : high < 0 ? -1 : 0; }
};
/// Both ends are rounded outwards.
[[nodiscard]] inline Ends operator+(const Ends& a, const Ends& b) {
  return {(Interval(a.low) + Interval(b.low)).lo(), (Interval(a.high) + Interval(b.high)).hi()};
}

/// A function of t on a stretch, and at its middle.
struct JetPair {
  Jet middle, over;
  Ends ends;  ///< of the values on the stretch
};

/// One component with everything that it refers to.
class ReferenceComponent {
 public:
  /// `component`'s own references are not followed: `kernel` and `transform` are the records that they refer to.
  /// `corners` are the blob's.
  ReferenceComponent(const scene::Component& component, std::shared_ptr<const KernelInUse> kernel,
                     const scene::Transform& transform, std::span<const scene::Vec3> corners);

  /// f and ∇f at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<Real>& p) const;
  /// Encloses f over a box in the blob's space.
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

  /// A line of the blob's space in the component's own.
  [[nodiscard]] Line local(const Line& line) const;
  // These are on a line in the component's own space.
  [[nodiscard]] Jet at(const Line& line, Real t) const;
  [[nodiscard]] JetPair on(const Line& line, const LineStretch& stretch) const;
  /// The effect at t of a relative error of q, or of all squared distances to a curve's points.
  [[nodiscard]] Real sensitivity_at(const Line& line, Real t) const;

  [[nodiscard]] const ReferenceSkeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const ReferenceKernel& kernel() const { return kernel_->profile; }
  /// Outside this box in the blob's space the field is zero.
  [[nodiscard]] Box support() const;

 private:
  /// Times the strength; `least` is no more than any value of `over`, which is not negative.
  [[nodiscard]] JetPair scaled(const Jet& middle, const Jet& over, Real least) const;

  ReferenceSkeleton skeleton_;
  std::shared_ptr<const KernelInUse> kernel_;
  std::shared_ptr<const ReferenceConvolution> convolution_;  ///< set if the kernel is integrated along the skeleton
  /// The inverse that the database keeps, because it defines the field; null if the component's space is the blob's.
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
  /// Outside this box all fields are zero.
  [[nodiscard]] const Box& bounds() const { return supports_.bounds(); }
  /// Appends the numbers of the components whose support the half-line may meet.
  void components_along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const {
    supports_.along(line, numbers);
  }
  [[nodiscard]] Real threshold() const { return threshold_; }

 private:
  std::vector<ReferenceComponent> components_;
  std::vector<std::uint32_t> branch_of_;
  std::vector<Maximum> maxima_;
  BoxTree supports_;
  std::size_t branch_count_ = 1;
  Real threshold_;
  bool is_unblended_;
};

}  // namespace isl::ISL_REFERENCE
