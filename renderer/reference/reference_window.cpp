// With y the squared distance from a place that moves with unit speed, y′² ≤ 4y and y″ = 2. So ∫g changes by
// |∫g′y′| ≤ ∫2√y|g′|, and bends by ∫(g″y′² + 2g′), between 2∫g′ and 4∫yg″:
//   quartic   2√y|g′| = 4√y(1 − y) ≤ 8/√27,   2g′ ≥ −4,      4yg″ = 8y ≤ 8
//   cauchy    2√y|g′| ≤ 4√y/Y³ ≤ 4/Y^(5/2),   2g′ ≥ −4/Y³,   4yg″ = 24y/Y⁴ ≤ 24/Y³.
// With P the least Y, the integral of a falling power of Y is its greatest value times the length at most, and no more
// than along a line of any length:
//   ∫(P + v²)⁻³dv = (3π/8)P^(−5/2),   ∫(P + v²)^(−5/2)dv = (4/3)P⁻²,
// times the spread; likewise ∫(P + v²)⁻²dv = (π/2)P^(−3/2), which bounds the value.
#include "renderer/reference/reference_window.h"

#include "base/check.h"
#include "renderer/reference/kernel_profiles.h"
#include "renderer/reference/quadrature.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace isl::ISL_REFERENCE {
namespace {

constexpr Real kLeastEpsilon = 1 / (Real(1e20L) * Real(1e20L));

/// The place where the falling f is 0, to the digits of logarithms; the nearer end if there is none. Regula falsi,
/// which halves the value that it remembers of an end that stays (the Illinois method): four steps square the error.
template <class Function>
Real root_of(Real low, Real high, const Function& f) {
  Real above = f(low), below = f(high);
  if (!(above > 0)) return low;
  if (!(below < 0)) return high;
  constexpr int kMostSteps = 400;
  int stayed = 0;  // the end that the last step left: −1 low, +1 high
  for (int step = 0; step < kMostSteps; ++step) {
    const bool is_slow = step % 8 == 7;
    const Real middle = low + (high - low) / 2;
    Real next = is_slow ? middle : low + (high - low) * (above / (above - below));
    if (!(next > low && next < high)) next = middle;
    const Real value = f(next);
    if (value == 0 || !(next > low && next < high)) return next;
    if (value > 0) {
      low = next;
      above = value;
      if (stayed == 1) below /= 2;
      stayed = 1;
    } else {
      high = next;
      below = value;
      if (stayed == -1) above /= 2;
      stayed = -1;
    }
    if (high - low <= 4 * kRoundoff * std::max(Real(1), abs(next))) return next;
  }
  return low + (high - low) / 2;
}

}  // namespace

ReferenceWindow::ReferenceWindow(const scene::Kernel& kernel)
    : is_quartic_(kernel.shape == scene::KernelShape::quartic) {
  ISL_CHECK(kernel.mode == scene::FieldMode::convolution);
  ISL_CHECK(is_quartic_ || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  if (!is_quartic_) {
    solve_cauchy(kernel.hardness);
    return;
  }
  // ∫(1 − y)² along a line is (16/15)(1 − y)^(5/2), whose logarithmic slope at y = 1/Q is −5/2/(Q − 1).
  const Real depth = 1 / (1 + Real(kernel.hardness) / 2.5L);
  border_ = 1 + 2.5L / Real(kernel.hardness);
  amplitude_ = Real(15) / (16 * depth * depth * sqrt(depth));
}

void ReferenceWindow::solve_cauchy(Real hardness) {
  static std::mutex mutex;
  static std::map<Real, ReferenceWindow> solved;  // kept, because solving takes milliseconds
  const std::lock_guard lock(mutex);
  if (const auto known = solved.find(hardness); known != solved.end()) {
    *this = known->second;
    return;
  }
  const Real log_epsilon = root_of(log(kLeastEpsilon), 100, [&](Real at) {
    epsilon_ = exp(at);
    return log(line(0).value / line(surface(hardness)).value) - hardness;
  });
  epsilon_ = exp(log_epsilon);
  const Real y = surface(hardness);
  border_ = 1 / y;
  amplitude_ = 1 / line(y).value;
  solved.emplace(hardness, *this);
}

/// On a line's surface φ = 1 and −qφ′ = h, of any amplitude −y∫g′ = h∫g. The quotient rises from 0 on the line without
/// bound towards the border. The odds y : (1 − y) are searched for, since soft windows of small ε have the surface far
/// within, and their logarithm, in which that of the quotient is nearly straight.
Real ReferenceWindow::surface(Real hardness) const {
  const auto at_odds = [](Real odds) { return odds / (1 + odds); };
  const Real log_odds = root_of(-800, 40, [&](Real log_of_odds) {
    const Real y = at_odds(exp(log_of_odds));
    const Values on_line = line(y);
    return log(hardness) - log(y * on_line.fall / on_line.value);
  });
  return at_odds(exp(log_odds));
}

ReferenceWindow::Values ReferenceWindow::at(Real y, Real to_border) const {
  const Real d = to_border;
  if (is_quartic_) return {d * d, 2 * d, 2};
  // g = (1/Y − 1/B)(1/Y + 1/B) − 2d/B³, −g′ = 2/Y³ − 2/B³, with the factor d = B − Y taken out.
  const Real a = epsilon_ + y, b = epsilon_ + 1, a2 = a * a, b3 = b * b * b;
  return {d * d * (b + 2 * a) / (a2 * b3), 2 * d * (b * (a + b) + a2) / (a2 * a * b3), 6 / (a2 * a2)};
}

ReferenceWindow::Values ReferenceWindow::line(Real y) const {
  Values sum{0, 0, 0};
  const Real end = sqrt(1 - y);
  integrate(0, end, pole(y), [&](Real v, Real weight) {
    const Values here = at(y + v * v, (end - v) * (end + v));
    sum.value += 2 * weight * here.value;
    sum.fall += 2 * weight * here.fall;
    sum.bend += 2 * weight * here.bend;
  });
  return sum;
}

ReferenceWindow::Bounds ReferenceWindow::bounds(const View& view) const {
  constexpr Size kMargin = 1 + 0x1p-40L;
  const Size length = static_cast<Size>(view.length) * kMargin, spread = static_cast<Size>(view.spread) * kMargin;
  const Size value = length * static_cast<Size>(at(view.least, 1 - view.least).value) * kMargin;
  const auto bend = [](Size unit) { return Interval(Real(-4 * unit), Real(24 * unit)); };
  if (is_quartic_) return {value, 1.5397L * length, Interval(Real(-4 * length), Real(8 * length))};
  const auto p = static_cast<Size>((epsilon_ + view.least) / kMargin);
  const Size root = std::sqrt(p) / kMargin;
  const Size of_line = 1.5708L * spread / (p * root) * kMargin;
  const Size slope = 4 * std::min(length / (p * p * root), 1.3334L * spread / (p * p));
  return {std::min(value, of_line), slope * kMargin,
          bend(std::min(length / (p * p * p), 1.1782L * spread / (p * p * root)) * kMargin)};
}

/// After the length x the curve is at most far + x away, and g falls.
Real ReferenceWindow::least(Real far, Real length) const {
  Real most = 0;
  for (const Real part : {(1 - far) / 2, far}) {
    const Real x = std::min(part, length), end = (far + x) * (1 + kPlaceRounding);
    if (x > 0 && end < 1) most = std::max(most, x * at(end * end, (1 - end) * (1 + end)).value);
  }
  return most * (1 - kIntegralRounding);
}

ProfileInUse line_profile(const scene::Kernel& kernel) {
  const ReferenceWindow window(kernel);
  const auto at = [=](Real q) {
    const Real y = q / window.border();
    if (!(y < 1)) return Jet();
    const ReferenceWindow::Values line = window.line(std::max(y, Real(0)));
    const Size a = Interval::size(window.amplitude()), change = a * kPlaceRounding;
    const auto range = [&](Real value, Real steepness) {
      return Interval::around(value * window.amplitude(),
                              Interval::size(value) * a * kIntegralRounding + Interval::size(steepness) * change);
    };
    // The fall may change by the bend, of which near the border little is left.
    return Jet{range(line.value, line.fall), -range(line.fall, line.bend), range(line.bend, line.bend)};
  };
  const auto profile = [=](const Jet& q) {
    const Jet here = q.value.radius() == 0 ? at(q.value.middle()) : hull(at(q.value.lo()), at(q.value.hi()));
    const Interval scale = Interval(1) / Interval(window.border());
    return chain(here.value, here.slope * scale, here.bend * square(scale), q);
  };
  // The conditions are solved to a few units in the last place of a logarithm of up to 100.
  return {profile, Interval::around(window.border(), Interval::size(window.border()) * (4096 * kRoundoff))};
}

}  // namespace isl::ISL_REFERENCE
