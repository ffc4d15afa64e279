// F(p) = Σ strength·φ(q) + Σ max(sums of branches) − threshold of a scene::Blob, straight from its definition: every
// component, in long double, without any structure in space. It judges the product's fields, with which it shares only
// the records of the database.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/reference/reference_convolution.h"
#include "renderer/reference/reference_kernel.h"
#include "renderer/reference/reference_skeleton.h"
#include "renderer/scene/database.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isl::reference {

/// Value, gradient (in units of value per length) and the size of the summed terms, from which rounding errors are
/// judged.
struct FieldSample {
  long double value = 0;
  Vector<long double> gradient{};
  long double sum_of_values = 0;  ///< Σ|fᵢ|
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
  [[nodiscard]] FieldSample sample(const Vector<long double>& p) const;
  /// Encloses f over a box in the blob's space.
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

  // These are on a line in the component's own space.
  [[nodiscard]] FieldRange at(const Line& line, long double t) const;
  struct Stretched {
    FieldRange all, first, last;
  };
  /// The field over a stretch, and at its ends.
  [[nodiscard]] Stretched over(const Line& line, long double t0, long double t1) const;
  /// The effect at t of a relative error of q, or of all squared distances to a curve's points.
  [[nodiscard]] long double sensitivity_at(const Line& line, long double t) const;

  [[nodiscard]] const ReferenceSkeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const ReferenceKernel& kernel() const { return kernel_; }
  [[nodiscard]] const scene::Matrix& component_from_blob() const { return component_from_blob_; }
  [[nodiscard]] bool has_transform() const { return has_transform_; }

 private:
  [[nodiscard]] FieldRange field_of(const DistanceOnLine& distance) const;
  [[nodiscard]] FieldRange strengthened(const FieldRange& f) const {
    return {strength_ * f.value, strength_ * f.derivative};
  }

  ReferenceSkeleton skeleton_;
  ReferenceKernel kernel_;
  std::optional<ReferenceConvolution> convolution_;  ///< set if the kernel is integrated along the skeleton
  scene::Matrix component_from_blob_;  ///< the inverse that the database keeps, because it defines the field
  Interval strength_;
  bool has_transform_;
};

/// Calls fold(parent, rivals) for each maximum, inner ones before outer ones: the greatest of the rivals' sums, which
/// are complete by then, belongs to the parent's sum.
template <class Fold>
void fold_maxima(const std::vector<scene::Branch>& branches, const Fold& fold) {
  // A branch has a greater number than its parent, so the maximum that begins last contains no other.
  for (std::uint32_t first = static_cast<std::uint32_t>(branches.size()); first-- > 1;) {
    if (branches[first].maximum != first) continue;
    std::vector<std::uint32_t> rivals;
    for (std::uint32_t b = first; b < branches.size(); ++b) {
      if (branches[b].maximum == first) rivals.push_back(b);
    }
    fold(branches[first].parent, std::span<const std::uint32_t>(rivals));
  }
}

class ReferenceField {
 public:
  ReferenceField(const scene::Database& database, const scene::Blob& blob);
  /// The plain sum of some of the blob's components, minus its threshold; `numbers` are indices of components.
  ReferenceField(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers);

  /// F and ∇F at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<long double>& p) const;
  [[nodiscard]] long double value(const Vector<long double>& p) const { return sample(p).value; }

  [[nodiscard]] const std::vector<ReferenceComponent>& components() const { return components_; }
  /// Branch 0 is the blob's sum. It is the only one if the blob has no maxima.
  [[nodiscard]] const std::vector<scene::Branch>& branches() const { return branches_; }
  /// The branch of each component.
  [[nodiscard]] std::uint32_t branch_of(std::size_t component) const { return branch_of_[component]; }
  [[nodiscard]] long double threshold() const { return threshold_; }

 private:
  void add(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers);

  std::vector<ReferenceComponent> components_;
  std::vector<std::uint32_t> branch_of_;
  std::vector<scene::Branch> branches_;
  long double threshold_;
};

}  // namespace isl::reference
