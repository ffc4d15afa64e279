// The field of a convolved segment or circle in its component's space, of strength 1: its window (reference_window.h) integrated
// along the curve numerically, and enclosures of what comes of it. Beside reference_skeleton and reference_kernel, which
// do the same for functions of a distance; must not know blobs.
//
// Enclosures. Value and gradient at a point carry what the rounding of the point and of 1 − y does to them. Over a box or a
// stretch of a line, bounds of the first and the second derivative hold around the values at a place or two.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/interval.h"
#include "tests/reference/reference_window.h"
#include "tests/reference/skeleton_forms.h"

#include <memory>

namespace isl::reference {

/// A curve in units of the support.
class Curve {
 public:
  virtual ~Curve() = default;
  [[nodiscard]] virtual long double distance(const Vector<long double>& p) const = 0;
  struct Integrals {
    long double value, fall;       ///< ∫g ds, ∫(−g′) ds
    Vector<long double> gradient;  ///< of the first
  };
  /// At a point within the support.
  [[nodiscard]] virtual Integrals integrals(const Vector<long double>& p, const ReferenceWindow& window) const = 0;
  /// As seen from a ball about p from where nothing is nearer than √least, least < 1.
  [[nodiscard]] virtual ReferenceWindow::View view(const Vector<long double>& p, long double ball,
                                                   long double least) const = 0;
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
    long double sensitivity = 0;  ///< how relative errors of the squared distances show, at most
  };
  /// At a point and its rounding.
  [[nodiscard]] Sample at(const Vector<Interval>& p) const;
  [[nodiscard]] FieldRange at(const Line& line, long double t) const;
  /// Over a stretch of a line, with what holds at its ends.
  [[nodiscard]] FieldRange over(const Line& line, long double t0, long double t1, const FieldRange& first,
                                const FieldRange& last) const;
  [[nodiscard]] Interval range(const Vector<Interval>& box) const;

 private:
  struct Ball {
    Vector<long double> centre;
    long double radius;
  };
  /// In units of the support.
  [[nodiscard]] Ball ball_of(const Vector<Interval>& p) const;

  ReferenceWindow window_;
  long double unit_;  ///< one over the support
  std::shared_ptr<const Curve> curve_;
};

}  // namespace isl::reference
