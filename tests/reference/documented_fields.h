// The fields as "Fields in closed form" of docs/language.md defines them, written from that page alone, formula by
// formula and in its order and letters. Nothing here may be taken from the renderer: if the two differ, the page is
// wrong or the renderer is.
#pragma once

#include <array>
#include <functional>
#include <string_view>

namespace isl::documented {

using Real = long double;
using Vector = std::array<Real, 3>;

// ---- Skeletons: q at p ----------------------------------------------------------------------------------------------

[[nodiscard]] Real sphere(const Vector& p, const Vector& c, Real r);
[[nodiscard]] Real cylinder(const Vector& p, const Vector& c1, const Vector& c2, Real r);
[[nodiscard]] Real cone(const Vector& p, const Vector& c1, Real r1, const Vector& c2, Real r2);
[[nodiscard]] Real box(const Vector& p, const Vector& corner, const Vector& opposite, Real r);
[[nodiscard]] Real torus(const Vector& p, Real ring, Real r);
[[nodiscard]] Real disc(const Vector& p, const Vector& c, const Vector& normal, Real ring, Real r);
[[nodiscard]] Real triangle(const Vector& p, const Vector& c1, const Vector& c2, const Vector& c3, Real r);
[[nodiscard]] Real plane(const Vector& p, const Vector& normal, Real d, Real r);
[[nodiscard]] Real convolved_plane(const Vector& p, const Vector& normal, Real d, Real r);

// ---- Kernels --------------------------------------------------------------------------------------------------------

struct Kernel {
  std::function<Real(Real)> phi;  ///< for q < border
  Real border;                    ///< Q
  Real a;

  [[nodiscard]] Real value(Real q) const { return q < border ? a * phi(q) : 0; }
};

/// `name` may also be empty, for POV-Ray's components.
[[nodiscard]] Kernel kernel(std::string_view name, Real h);
/// The window of a convolved plane: "quartic" or "cauchy".
[[nodiscard]] Kernel plane_kernel(std::string_view name, Real h);

/// The ε and the border Q of the kernel "cauchy".
struct CauchyConstants {
  Real epsilon, border;
};
[[nodiscard]] CauchyConstants cauchy_constants(Real h);

// ---- Convolved curves: the whole field, with strength 1 -------------------------------------------------------------

class Convolution {
 public:
  Convolution(std::string_view name, Real h);

  [[nodiscard]] Real cylinder(const Vector& p, const Vector& c1, const Vector& c2, Real r) const;
  [[nodiscard]] Real torus(const Vector& p, Real ring, Real r) const;

 private:
  /// L(y) and L′(y).
  [[nodiscard]] Real line(Real y) const;
  [[nodiscard]] Real line_slope(Real y) const;
  [[nodiscard]] Real line_surface(Real h) const;

  bool is_quartic_;
  Real epsilon_ = 0;
  Real support_ = 0;  ///< ρ/r
  Real a_ = 0;
};

}  // namespace isl::documented
