// One component of a blob with everything that it refers to, and its field along a line in its own space.
#pragma once

#include "renderer/extended/extended_convolution.h"
#include "renderer/extended/extended_kernel.h"
#include "renderer/extended/extended_skeleton.h"
#include "renderer/extended/interval.h"
#include "renderer/scene/database.h"

#include <memory>
#include <span>

namespace isl::ISL_EXTENDED {

/// `p·M` and `v·M` for an affine M with row vectors (the database's convention), without rounding M.
[[nodiscard]] Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m);
[[nodiscard]] Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m);

class ExtendedComponent {
 public:
  /// `corners` are the blob's. `profile` is the kernel that the component refers to, and `kernel` its record.
  ExtendedComponent(const scene::Component& component, const scene::Kernel& kernel, const ExtendedKernel& profile,
                    const scene::Transform& transform, std::span<const scene::Vec3> corners);

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

  [[nodiscard]] const ExtendedSkeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const ExtendedKernel& kernel() const { return kernel_; }
  /// A line of the blob's space in the component's.
  [[nodiscard]] Line enter(const Line& line) const;

 private:
  [[nodiscard]] FieldRange field_of(const DistanceOnLine& distance) const;
  [[nodiscard]] FieldRange strengthened(const FieldRange& f) const {
    return {strength_ * f.value, strength_ * f.derivative};
  }

  ExtendedSkeleton skeleton_;
  ExtendedKernel kernel_;
  std::shared_ptr<const ExtendedConvolution> convolution_;  ///< set if the kernel is integrated along the skeleton
  /// The inverse that the database keeps, because it defines the field. Null if the component's space is the blob's.
  const scene::Matrix* component_from_blob_;
  Interval strength_;
};

}  // namespace isl::ISL_EXTENDED
