// The kernels and their first four derivatives, written out by hand from their definitions in long double, to test the
// bounds in renderer/fields/kernels. Only Q comes from the product (the conformance suite tests it), and nothing else
// of how its kernels are written may be used.
//
// φ(q) = p(q)/p(1), q the squared distance over the squared radius, h the hardness, for 0 ≤ q < Q:
//   quartic   p = (1 − q/Q)²
//   cubic     p = (1 − q/Q)³
//   gaussian  p = e^{−a(q−1)} less its tangent at Q, a = h(1 − δ(1 + ln 1/δ))/(1 − δ), δ = 10⁻³
//   gaussian  p = e^{−a(q−1)} minus its tangent at Q, a = h(1 − δ(1 + ln 1/δ))/(1 − δ), δ = 10⁻³
//   metaball  p = 1 − 3x for x ≤ 1/9, (3/2)(1 − √x)² from there
//   cauchy    p = (1 + σ²q)⁻² minus its tangent at Q, σ from φ(0) = eʰ
// and of planes that are convolved with the windows quartic and cauchy:
//   quartic   p = (1 − q/Q)³
//   cauchy    p = (1 + σ²q)⁻¹ minus its parabola at Q, σ from φ(0) = eʰ
#pragma once

#include <array>
#include <cmath>
#include <functional>

namespace isl::render {

/// φ, φ′, φ″, φ‴, φ⁗ with respect to q.
using Derivatives = std::array<long double, 5>;

struct KernelDefinition {
  std::function<Derivatives(long double q)> at;
  long double jump = 0;  ///< q where φ″ jumps; 0 if it does not
};

/// p(q) with its derivatives, over p(1).
template <class Unscaled>
[[nodiscard]] std::function<Derivatives(long double)> normalised(const Unscaled& p) {
  return [p, one = p(1.0L)[0]](long double q) {
    Derivatives d = p(q);
    for (long double& each : d) each /= one;
    return d;
  };
}

/// A function minus its tangent at `border`.
template <class Function>
[[nodiscard]] auto less_tangent(const Function& f, long double border) {
  return [f, border, at_border = f(border)](long double q) {
    Derivatives d = f(q);
    d[0] -= at_border[0] + at_border[1] * (q - border);
    d[1] -= at_border[1];
    return d;
  };
}

[[nodiscard]] inline KernelDefinition quartic_definition(long double, long double border) {
  return {normalised([border](long double q) {
    const long double y = 1 - q / border;
    return Derivatives{y * y, -2 * y / border, 2 / (border * border), 0, 0};
  })};
}

[[nodiscard]] inline KernelDefinition gaussian_definition(long double hardness, long double border) {
  const long double delta = 1e-3L, a = hardness * (1 - delta * (1 + std::log(1 / delta))) / (1 - delta);
  const auto exponential = [a](long double q) {
    const long double e = std::exp(-a * (q - 1));
    return Derivatives{e, -a * e, a * a * e, -a * a * a * e, a * a * a * a * e};
  };
  return {normalised(less_tangent(exponential, border))};
}

[[nodiscard]] inline KernelDefinition soft_definition(long double, long double border) {
  return {normalised([border](long double q) {
    const long double x = q / border, b = border;
    return Derivatives{1 - 22 * x / 9 + 17 * x * x / 9 - 4 * x * x * x / 9, (-22 + 34 * x - 12 * x * x) / (9 * b),
                       (34 - 24 * x) / (9 * b * b), -24 / (9 * b * b * b), 0};
  })};
}

[[nodiscard]] inline KernelDefinition metaball_definition(long double, long double border) {
  const auto unscaled = [border](long double q) {
    const long double x = q / border, b = border, root = std::sqrt(x);
    if (9 * x <= 1) return Derivatives{1 - 3 * x, -3 / b, 0, 0, 0};
    return Derivatives{1.5L * (1 - root) * (1 - root), 1.5L * (1 - 1 / root) / b, 0.75L / (x * root * b * b),
                       -1.125L / (x * x * root * b * b * b), 2.8125L / (x * x * x * root * b * b * b * b)};
  };
  return {normalised(unscaled), border / 9};
}

[[nodiscard]] inline KernelDefinition cauchy_definition(long double hardness, long double border) {
  const auto less_its_tangent = [border](long double sigma_squared) {
    const auto cauchy = [k = sigma_squared](long double q) {
      const long double s = 1 / (1 + k * q), s2 = s * s;
      return Derivatives{s2, -2 * k * s2 * s, 6 * k * k * s2 * s2, -24 * k * k * k * s2 * s2 * s,
                         120 * k * k * k * k * s2 * s2 * s2};
    };
    return less_tangent(cauchy, border);
  };
  // The ratio of the middle to the surface rises with σ: bisects ln σ².
  long double low = -6, high = hardness;
  for (int i = 0; i < 90; ++i) {
    const long double middle = (low + high) / 2;
    const auto p = less_its_tangent(std::exp(middle));
    (std::log(p(0)[0] / p(1)[0]) < hardness ? low : high) = middle;
  }
  return {normalised(less_its_tangent(std::exp(low)))};
}

[[nodiscard]] inline KernelDefinition cubic_definition(long double, long double border) {
  return {normalised([border](long double q) {
    const long double y = 1 - q / border, b = border;
    return Derivatives{y * y * y, -3 * y * y / b, 6 * y / (b * b), -6 / (b * b * b), 0};
  })};
}

[[nodiscard]] inline KernelDefinition cauchy_sheet_definition(long double hardness, long double border) {
  const auto less_its_parabola = [border](long double k) {
    const auto plain = [k](long double q) {
      const long double s = 1 / (1 + k * q), s2 = s * s;
      return Derivatives{s, -k * s2, 2 * k * k * s2 * s, -6 * k * k * k * s2 * s2, 24 * k * k * k * k * s2 * s2 * s};
    };
    return [plain, border, at_border = plain(border)](long double q) {
      Derivatives d = plain(q);
      const long double x = q - border;
      d[0] -= at_border[0] + x * (at_border[1] + x * at_border[2] / 2);
      d[1] -= at_border[1] + x * at_border[2];
      d[2] -= at_border[2];
      return d;
    };
  };
  // As above. σ² ends at 10⁴⁰, where a harder sheet only changes within 10⁻²⁰ radii of its plane.
  long double low = -6, high = std::min(hardness + 10, std::log(1e40L));
  for (int i = 0; i < 90; ++i) {
    const long double middle = (low + high) / 2;
    const auto p = less_its_parabola(std::exp(middle));
    (std::log(p(0)[0] / p(1)[0]) < hardness ? low : high) = middle;
  }
  return {normalised(less_its_parabola(std::exp(low)))};
}

}  // namespace isl::render
