// Along a line of unit speed, y′² ≤ 4y and y″ = 2, so the second derivative of g(y) is y′²g″ + 2g′ with
//   quartic   |8(y′²/4) − 4(1 − y)| ≤ 8
//   cauchy    g″ = 6/Y⁴, −2/Y³ ≤ g′ ≤ 0: between −4/Y³ and 24y/Y⁴ < 24/Y³
// and the first derivative is |y′g′| ≤ 4√y(1 − y) < 1.54, or 4√y/Y³ < 4/Y^{5/2}. Integrals along a curve no nearer than
// least are bounded by the length times the value at the least distance or, for the falling powers, with P = ε + least,
// as along a line of any length, by
//   ∫(P + v²)⁻³dv = (3π/8)√P/P³,   ∫(P + v²)^{−5/2}dv = (4/3)√P/P^{5/2},
// times the spread.
#include "renderer/reference/reference_window.h"

#include "base/check.h"
#include "renderer/reference/graded_quadrature.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace isl::ISL_REFERENCE {
namespace {

constexpr Real kLeastEpsilon = 1 / (Real(1e20L) * Real(1e20L));

/// The place where the falling f is 0, by Ridders' method (W. H. Press et al., Numerical Recipes, 9.2.1), each of whose
/// steps at least halves the bracket and, near the root, doubles the digits. The end that is nearer if there is none.
/// The arguments are logarithms, of which digits beyond those of 1 mean nothing.
template <class Function>
Real root_of(Real low, Real high, const Function& f) {
  Real above = f(low), below = f(high);
  if (!(above > 0)) return low;
  if (!(below < 0)) return high;
  Real root = low;
  while (true) {
    const Real middle = low + (high - low) / 2, there = f(middle);
    if (middle == low || middle == high || there == 0) return middle;
    const Real half = (high - low) / 2, last = root;
    root = std::clamp(middle + half * there / sqrt(there * there - above * below), low, high);
    const Real value = f(root);
    if (value == 0 || abs(root - last) <= kRounding * std::max(Real(1), abs(root))) return root;
    // The bracket's new ends are the neighbours of the root among low, middle, root and high.
    const auto narrow = [&](Real x, Real y) {
      (y > 0 ? low : high) = x;
      (y > 0 ? above : below) = y;
    };
    narrow(middle, there);
    if (root > low && root < high) narrow(root, value);
  }
}

}  // namespace

ReferenceWindow::ReferenceWindow(const scene::Kernel& kernel)
    : is_quartic_(kernel.shape == scene::KernelShape::quartic) {
  ISL_CHECK(kernel.mode == scene::FieldMode::convolution);
  ISL_CHECK(is_quartic_ || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  if (is_quartic_) {
    solve_quartic(kernel.hardness);
  } else {
    solve_cauchy(kernel.hardness);
  }
}

/// For a line the integral is (16/15)(1 − y)^{5/2}: φ′/φ = −5/2/(Q − q).
void ReferenceWindow::solve_quartic(Real hardness) {
  border_ = 1 + 2.5L / hardness;
  amplitude_ = 1 / line(1 / border_).value;
}

void ReferenceWindow::solve_cauchy(Real hardness) {
  static std::mutex mutex;
  static std::map<Real, ReferenceWindow> solved;  // cached, because solving takes a tenth of a second
  const std::lock_guard lock(mutex);
  if (const auto known = solved.find(hardness); known != solved.end()) {
    *this = known->second;
    return;
  }
  const Real log_epsilon = root_of(log(kLeastEpsilon), log(Real(1e6L)), [&](Real at) {
    epsilon_ = exp(at);
    return log(line(0).value / line(surface(hardness)).value) - Real(hardness);
  });
  epsilon_ = exp(log_epsilon);
  const Real y = surface(hardness);
  border_ = 1 / y;
  amplitude_ = 1 / line(y).value;
  solved.emplace(hardness, *this);
}

/// y of a line's surface, where −y∫g′/∫g = h; the left side rises from 0 on the line. It is solved for ln(y/(1 − y)),
/// because soft windows of small ε have it far within, and by logarithms, which are nearly straight there.
Real ReferenceWindow::surface(Real hardness) const {
  const auto place = [](Real u) { return 1 / (1 + exp(-u)); };
  return place(root_of(-100, 40, [&](Real u) {
    const Real y = place(u);
    const Value here = line(y);
    return log(hardness * here.value / (y * here.fall));
  }));
}

ReferenceWindow::Value ReferenceWindow::at(Real y, Real to_border) const {
  const Real d = to_border;
  if (is_quartic_) return {d * d, 2 * d};
  const Real a = epsilon_ + y, b = epsilon_ + 1, b3 = b * b * b;
  return {d * d * (b + 2 * a) / (a * a * b3), 2 * d * (b * b + a * b + a * a) / (a * a * a * b3)};
}

Real ReferenceWindow::scale(Real y) const { return is_quartic_ ? 2 : sqrt(epsilon_ + y); }

Real ReferenceWindow::most_bend(const View& view) const {
  if (is_quartic_) return 8 * view.length * kWindowMargin;
  const Real p = epsilon_ + view.least;
  return 24 * std::min(view.length, 1.1781L * sqrt(p) * view.spread) / (p * p * p) * kWindowMargin;
}

Real ReferenceWindow::most_slope(const View& view) const {
  if (is_quartic_) return 1.54L * view.length * kWindowMargin;
  const Real p = epsilon_ + view.least;
  return 4 * std::min(view.length, 1.3334L * sqrt(p) * view.spread) / (p * p * sqrt(p)) * kWindowMargin;
}

Real ReferenceWindow::most(const View& view) const {
  return view.length * at(view.least, 1 - view.least).value * kWindowMargin;
}

ReferenceWindow::Value ReferenceWindow::line(Real y) const {
  Value sum{0, 0};
  const Real end2 = 1 - y, end = sqrt(end2);
  integrate_graded(0, end, scale(y), [&](Real v, Real weight) {
    const Value here = at(y + v * v, (end - v) * (end + v));
    sum.value += 2 * weight * here.value;
    sum.fall += 2 * weight * here.fall;
  });
  return sum;
}

}  // namespace isl::ISL_REFERENCE
