#include "renderer/fields/kernels/curve_constants.h"

#include "base/check.h"
#include "renderer/numerics/bisection.h"

#include <cmath>

namespace isl::render {
namespace {

/// An infinite line convolved with the Cauchy window, at y = ρ² in support radii: P = ε + y, w² = 1 − y, B = ε + 1,
///   L = w/(PB) + atan(w/√P)/P^{3/2} − 2w/B² − (8/3)w³/B³
///   L′ = −w/(PB²) − 3w/(2P²B) − (3/2)atan(w/√P)/P^{5/2} + 4w/B³.
struct CauchyLine {
  double epsilon;

  [[nodiscard]] double value(double y) const {
    const double p = epsilon + y, w = std::sqrt(1 - y), b = 1 + epsilon;
    return w / (p * b) + std::atan2(w, std::sqrt(p)) / (p * std::sqrt(p)) - 2 * w / (b * b) -
           (8.0 / 3) * w * w * w / (b * b * b);
  }
  [[nodiscard]] double slope(double y) const {
    const double p = epsilon + y, w = std::sqrt(1 - y), b = 1 + epsilon;
    return -w / (p * b * b) - 1.5 * w / (p * p * b) - 1.5 * std::atan2(w, std::sqrt(p)) / (p * p * std::sqrt(p)) +
           4 * w / (b * b * b);
  }
  /// The y at which −yL′/L = h, the surface; −yL′/L rises from 0 on the line towards the border. Bisection is in
  /// ln(y/(1 − y)), since the surface of a soft line can lie at a tiny y.
  [[nodiscard]] double surface(double h) const {
    const auto is_within = [&](double u) {
      const double y = place(u);
      return -y * slope(y) < h * value(y);
    };
    return place(last_where(is_within, -140, 40));
  }

 private:
  [[nodiscard]] static double place(double u) { return 1 / (1 + std::exp(-u)); }
};

KernelConstants quartic(double h) {
  KernelConstants constants;
  const double root = 1 + h / 2.5;
  constants.scale = h / (h + 2.5);
  constants.amplitude = (15.0 / 16) * root * root * std::sqrt(root);
  return constants;
}

/// Among the windows with the value 1 and the slope −h at the surface, the one whose infinite line has the value eʰ on
/// itself, as the point's kernel has.
/// The ratio of the values falls from above eʰ to below it (the quartic's) as ε grows. Below ε = 10⁻⁴⁰, a hardness of
/// about 150, only the value within 10⁻²⁰ of the line changes, and the powers of ε would leave the range of numbers.
KernelConstants cauchy(double h) {
  const auto is_too_small = [h](double log_epsilon) {
    const CauchyLine line{std::exp(log_epsilon)};
    return std::log(line.value(0) / line.value(line.surface(h))) > h;
  };
  KernelConstants constants;
  constants.a = std::exp(last_where(is_too_small, std::log(1e-40), std::log(1e6)));
  const CauchyLine line{constants.a};
  constants.scale = line.surface(h);
  constants.amplitude = 1 / line.value(constants.scale);
  return constants;
}

}  // namespace

KernelConstants curve_constants(const scene::Kernel& kernel) {
  ISL_CHECK(kernel.meaning == scene::RadiusMeaning::surface, "meaning {}", static_cast<int>(kernel.meaning));
  ISL_CHECK(kernel.hardness > 0 && kernel.hardness <= 500, "{}", kernel.hardness);
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  KernelConstants constants = is_quartic ? quartic(kernel.hardness) : cauchy(kernel.hardness);
  constants.shape = kernel.shape;
  constants.is_convolved = true;
  return constants;
}

}  // namespace isl::render
