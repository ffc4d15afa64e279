#include "renderer/fields/kernels/curve_constants.h"

#include "base/check.h"
#include "renderer/numerics/bisection.h"

#include <cmath>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace isl::render {
namespace {

/// The squared distance y of a line's surface, in support radii, and 1 − y, each with all its digits.
struct SurfaceAt {
  double y, rest;
};

/// An infinite line convolved with the Cauchy window, at y = ρ² in support radii: P = ε + y, w² = 1 − y, B = ε + 1,
///   L = w/(PB) + atan(w/√P)/P^{3/2} − 2w/B² − (8/3)w³/B³
///   L′ = −w/(PB²) − 3w/(2P²B) − (3/2)atan(w/√P)/P^{5/2} + 4w/B³.
/// Towards the border both are small differences of great terms: L falls as w⁵. There the window is expanded in
/// (1 − y)/B, (3 − 2z)/(1 − z)² = Σ(k + 3)zᵏ; with x = w²/B and Jₙ = ∫(1 − s²)ⁿds from −1 to 1,
///   L = w⁵/B⁴ Σ (k + 3) J_{k+2} xᵏ,   L′ = −w³/B⁴ Σ (k + 5/2)(k + 3) J_{k+2} xᵏ,   Jₙ = Jₙ₋₁ 2n/(2n + 1),
/// in which nothing cancels. From x = ½ on no term above is greater than twice the sum.
struct CauchyLine {
  double epsilon;

  [[nodiscard]] double value(const SurfaceAt& at) const { return sums(at).value; }
  /// −yL′/L.
  [[nodiscard]] double hardness(const SurfaceAt& at) const {
    const Sums line = sums(at);
    return at.y * line.fall / line.value;
  }
  /// Where −yL′/L = h; that quotient rises from 0 on the line towards the border. It is searched for 1 − y near the
  /// border, and for ln(y/(1 − y)) elsewhere, since the surface of a soft line can lie at a tiny y.
  [[nodiscard]] SurfaceAt surface(double h) const {
    if (hardness({0.5, 0.5}) < h) {
      const double rest = last_where([&](double r) { return hardness({1 - r, r}) >= h; }, 0, 0.5);
      return {1 - rest, rest};
    }
    const auto place = [](double u) { return SurfaceAt{1 / (1 + std::exp(-u)), 1 / (1 + std::exp(u))}; };
    return place(last_where([&](double u) { return hardness(place(u)) < h; }, -140, 1));
  }

 private:
  struct Sums {
    double value, fall;  ///< L and −L′
  };
  [[nodiscard]] Sums sums(const SurfaceAt& at) const {
    const double w = std::sqrt(at.rest), b = 1 + epsilon, x = at.rest / b;
    if (x < 0.5) return near_border(w, b, x);
    const double p = epsilon + at.y, angle = std::atan2(w, std::sqrt(p)) / (p * std::sqrt(p));
    return {w / (p * b) + angle - 2 * w / (b * b) - (8.0 / 3) * w * w * w / (b * b * b),
            w / (p * b * b) + 1.5 * w / (p * p * b) + 1.5 * angle / p - 4 * w / (b * b * b)};
  }
  [[nodiscard]] static Sums near_border(double w, double b, double x) {
    constexpr int kTerms = 64;  // the rest is below 2⁻⁵⁶ of the sum
    Sums sum{0, 0};
    double term = 16.0 / 15;  // J_{k+2} xᵏ
    for (int k = 0; k < kTerms; ++k) {
      sum.value += (k + 3) * term;
      sum.fall += (k + 2.5) * (k + 3) * term;
      term *= x * (2 * k + 6) / (2 * k + 7);
    }
    const double w3 = w * w * w / (b * b * b * b);
    return {w3 * w * w * sum.value, w3 * sum.fall};
  }
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
    return std::log(line.value({0, 1}) / line.value(line.surface(h))) > h;
  };
  KernelConstants constants;
  constants.a = std::exp(last_where(is_too_small, std::log(1e-40), std::log(1e6)));
  const CauchyLine line{constants.a};
  const SurfaceAt surface = line.surface(h);
  constants.scale = surface.y;
  constants.amplitude = 1 / line.value(surface);
  return constants;
}

/// The same, searched for once: it takes milliseconds, and several parts of the program ask for the constants of each
/// of a scene's kernels.
KernelConstants remembered_cauchy(double h) {
  constexpr std::size_t kMost = 64;  // so that a scene with a kernel for each component does not grow the list for ever
  static std::mutex mutex;
  static std::vector<std::pair<double, KernelConstants>> known;
  const std::scoped_lock lock(mutex);
  for (const auto& [hardness, constants] : known) {
    if (hardness == h) return constants;
  }
  if (known.size() == kMost) known.clear();
  return known.emplace_back(h, cauchy(h)).second;
}

}  // namespace

KernelConstants curve_constants(const scene::Kernel& kernel) {
  ISL_CHECK(kernel.meaning == scene::RadiusMeaning::surface, "meaning {}", static_cast<int>(kernel.meaning));
  ISL_CHECK(kernel.hardness > 0 && kernel.hardness <= 500, "{}", kernel.hardness);
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  KernelConstants constants = is_quartic ? quartic(kernel.hardness) : remembered_cauchy(kernel.hardness);
  constants.shape = kernel.shape;
  constants.is_convolved = true;
  return constants;
}

}  // namespace isl::render
