// The window of a convolution, straight from its definition (docs/language.md): the function that is
// integrated along a curve. With y the squared distance to a point of the curve over the squared support,
//   quartic   g = (1 − y)²,
//   cauchy    g = 1/Y² minus its tangent at the border, Y = ε + y, B = ε + 1;
// for an infinite straight line at the squared distance of q radii squared, y = q/Q, it gives φ(q) with φ(1) = 1 and
// φ′(1) = −h. The Cauchy window also gives φ(0) = eʰ, or has the least ε, 10⁻⁴⁰. The conditions are solved with lines
// that are integrated numerically: nothing here uses a closed form.
#pragma once

#include "renderer/reference/real.h"
#include "renderer/scene/database.h"

namespace isl::ISL_REFERENCE {

/// Bounds are widened by this factor, which allows for their own rounding.
inline constexpr Real kWindowMargin = 1 + 0x1p-50L;

/// The relative error of an integral of the window: of its terms, which have one sign, and of their number.
inline constexpr Real kIntegralRounding = 128 * kRoundoff;
/// 1 − y is known to a few units in the last place of 1, so an integral is uncertain by this share of that of −dg/dy.
inline constexpr Real kPlaceRounding = 16 * kRoundoff;

class ReferenceWindow {
 public:
  /// Precondition: mode convolution, shape quartic or cauchy.
  explicit ReferenceWindow(const scene::Kernel& kernel);

  /// Q: the squared support over the squared radius.
  [[nodiscard]] Real border() const { return border_; }
  /// The factor that makes φ(1) = 1 of integrals whose lengths are in supports.
  [[nodiscard]] Real amplitude() const { return amplitude_; }

  struct Value {
    Real value, fall;  ///< g and −dg/dy
  };
  /// The window, given y and 1 − y > 0, which a caller may know to more digits.
  [[nodiscard]] Value at(Real y, Real to_border) const;
  /// The distance from a straight line within which g along it is analytic, where y is the squared distance of the
  /// nearest point.
  [[nodiscard]] Real scale(Real y) const;

  /// A part of a curve, seen from a place to which no point of it is nearer than √least.
  struct View {
    Real least;   ///< < 1
    Real length;  ///< length of the part within the support, or more
    Real spread;  ///< the distance grows along the curve at least as along a straight line this much shorter
  };
  /// Bounds of the second and the first derivative of ∫g, along a line that is followed with unit speed.
  [[nodiscard]] Real most_bend(const View& view) const;
  [[nodiscard]] Real most_slope(const View& view) const;
  /// Bound of ∫g.
  [[nodiscard]] Real most(const View& view) const;

  /// ∫g and ∫(−dg/dy) along an infinite line at the squared distance y < 1.
  [[nodiscard]] Value line(Real y) const;

 private:
  void solve_quartic(Real hardness);
  void solve_cauchy(Real hardness);
  [[nodiscard]] Real surface(Real hardness) const;

  bool is_quartic_;
  Real epsilon_ = 0, border_ = 1, amplitude_ = 1;
};

}  // namespace isl::ISL_REFERENCE
