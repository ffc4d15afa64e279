// The field of a convolved segment or circle in its component's space, with strength 1: its window
// (reference_window.h), integrated along the curve numerically, and enclosures of the results. It stands beside
// reference_skeleton and reference_kernel, which do the same for functions of a distance; it must not know blobs.
//
// Enclosures: value and gradient at a point include the effects of rounding in the point and in 1 − y. Over a box or a
// stretch of a line, bounds of the first and the second derivative hold around the values at one or two places.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/reference/reference_window.h"
#include "renderer/reference/skeleton_forms.h"
#include "renderer/scene/database.h"

#include <memory>

namespace isl::ISL_REFERENCE {

/// A curve in units of the support.
class Curve {
 public:
  virtual ~Curve() = default;
  [[nodiscard]] virtual Real distance(const Vector<Real>& p) const = 0;
  struct Integrals {
    Real value, fall;       ///< ∫g ds, ∫(−g′) ds
    Vector<Real> gradient;  ///< of the first integral
  };
  /// The integrals at a point within the support.
  [[nodiscard]] virtual Integrals integrals(const Vector<Real>& p, const ReferenceWindow& window) const = 0;
  /// The view from a ball about p, from which nothing is nearer than √least, least < 1.
  [[nodiscard]] virtual ReferenceWindow::View view(const Vector<Real>& p, Real ball, Real least) const = 0;
};

/// f and its derivative along a line.
struct FieldRange {
  Interval value, derivative;
};

class ReferenceConvolution {
 public:
  /// Precondition: a segment or a circle, with a kernel of the mode convolution.
  ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel);

  struct Sample {
    Interval value;
    Vector<Interval> gradient;
    Real sensitivity = 0;  ///< largest effect of relative errors of the squared distances
  };
  /// The field at a point, with the point's rounding.
  [[nodiscard]] Sample at(const Vector<Interval>& p) const;
  [[nodiscard]] FieldRange at(const Line& line, Real t) const;
  /// The field over a stretch of a line, from the fields at its ends.
  [[nodiscard]] FieldRange over(const Line& line, Real t0, Real t1, const FieldRange& first,
                                const FieldRange& last) const;
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

 private:
  struct Ball {
    Vector<Real> centre;
    Real radius;
  };
  /// The ball in units of the support.
  [[nodiscard]] Ball ball_of(const Vector<Interval>& p) const;

  ReferenceWindow window_;
  Real unit_;  ///< one over the support
  std::shared_ptr<const Curve> curve_;
};

}  // namespace isl::ISL_REFERENCE
