// F(p) = Σ strength·φ(q) − threshold of a scene::Blob straight from its definition: every component, long double, no
// structure in space. The judge of the product's fields, with which it shares only the records of the database.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/interval.h"
#include "tests/reference/reference_kernel.h"
#include "tests/reference/reference_skeleton.h"

#include <span>
#include <vector>

namespace isl::reference {

/// Value, gradient (units of value a length) and the size of what was added up, from which rounding errors are judged.
struct FieldSample {
  long double value = 0;
  Vector<long double> gradient{};
  long double sum_of_values = 0;  ///< Σ|fᵢ|
};

/// `p·M` and `v·M` for an affine M with row vectors (the database's convention), without rounding M.
[[nodiscard]] Vector<Interval> transformed_point(const Vector<Interval>& p, const scene::Matrix& m);
[[nodiscard]] Vector<Interval> transformed_vector(const Vector<Interval>& v, const scene::Matrix& m);

/// One component with all it refers to.
class ReferenceComponent {
 public:
  /// `component`'s own references are not looked up: `kernel` and `transform` are what they refer to. `corners` are the
  /// blob's.
  ReferenceComponent(const scene::Component& component, const ReferenceKernel& kernel,
                     const scene::Transform& transform, std::span<const scene::Vec3> corners);

  /// f and ∇f at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<long double>& p) const;
  /// Encloses f over a box in the blob's space.
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

  [[nodiscard]] const ReferenceSkeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const ReferenceKernel& kernel() const { return kernel_; }
  [[nodiscard]] const scene::Matrix& component_from_blob() const { return component_from_blob_; }
  [[nodiscard]] bool has_transform() const { return has_transform_; }
  [[nodiscard]] Interval strength() const { return strength_; }

 private:
  ReferenceSkeleton skeleton_;
  ReferenceKernel kernel_;
  scene::Matrix component_from_blob_;  ///< the inverse that the database keeps: it is what defines the field
  Interval strength_;
  bool has_transform_;
};

class ReferenceField {
 public:
  ReferenceField(const scene::Database& database, const scene::Blob& blob);

  /// F and ∇F at p in the blob's space.
  [[nodiscard]] FieldSample sample(const Vector<long double>& p) const;
  [[nodiscard]] long double value(const Vector<long double>& p) const { return sample(p).value; }

  [[nodiscard]] const std::vector<ReferenceComponent>& components() const { return components_; }
  [[nodiscard]] long double threshold() const { return threshold_; }

 private:
  std::vector<ReferenceComponent> components_;
  long double threshold_;
};

}  // namespace isl::reference
