// The window of a convolution as docs/language.md defines it: the function that is integrated along a curve. With y the
// squared distance to a point of the curve over the squared support,
//   quartic   g = (1 − y)²,
//   cauchy    g = 1/Y² less its tangent at the border, Y = ε + y, B = ε + 1;
// for an infinite straight line at the squared distance of q radii squared, y = q/Q, it gives φ(q) with φ(1) = 1 and
// φ′(1) = −h. The cauchy window also gives φ(0) = eʰ, or has the least ε, 10⁻⁴⁰. Its constants are solved for with
// lines that are integrated numerically.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/scene/database.h"

namespace isl::ISL_REFERENCE {

/// The relative error of an integral of the window: of its terms, which have one sign, of their number and of the
/// constants.
inline constexpr Size kIntegralRounding = 128 * kRoundoff;
/// 1 − y is known to a few units in the last place of 1, so an integral is uncertain by this share of that of −g′.
inline constexpr Size kPlaceRounding = 16 * kRoundoff;

class ReferenceWindow {
 public:
  /// Precondition: mode convolution, shape quartic or cauchy.
  explicit ReferenceWindow(const scene::Kernel& kernel);

  /// Q: the squared support over the squared radius.
  [[nodiscard]] Real border() const { return border_; }
  /// The factor that makes φ(1) = 1 of integrals whose lengths are in supports.
  [[nodiscard]] Real amplitude() const { return amplitude_; }

  /// g, −g′ and g″, or integrals of them.
  struct Values {
    Real value, fall, bend;
  };
  /// The window, given y and 1 − y > 0, which a caller may know to more digits.
  [[nodiscard]] Values at(Real y, Real to_border) const;
  /// How far from a straight line's point nearest to the poles of g along it are, where y is the squared distance of
  /// that point.
  [[nodiscard]] Real pole(Real y) const { return is_quartic_ ? 2 : sqrt(epsilon_ + y); }

  /// The integrals along an infinite line at the squared distance y < 1.
  [[nodiscard]] Values line(Real y) const;

  /// A part of a curve, seen from places to which no point of it is nearer than √least.
  struct View {
    Real least;   ///< below 1
    Real length;  ///< length of the part within the support, or more
    Real spread;  ///< the distance grows along the curve at least as along a straight line this much shorter
  };
  /// Bounds of ∫g for a place that moves with unit speed: of its value, its slope and its bend.
  struct Bounds {
    Size most_value, most_slope;
    Interval bend;
  };
  [[nodiscard]] Bounds bounds(const View& view) const;
  /// No more than ∫g along this length of a curve whose beginning is at most `far` away.
  [[nodiscard]] Real least(Real far, Real length) const;

 private:
  void solve_cauchy(Real hardness);
  /// y of a line's surface.
  [[nodiscard]] Real surface(Real hardness) const;

  bool is_quartic_;
  Real epsilon_ = 0, border_ = 1, amplitude_ = 1;
};

}  // namespace isl::ISL_REFERENCE
