// The kernels of the product against those of the reference, at every hardness: φ is off by no more than the rounding
// of its value and of q allows (rounding_rule.h), from half the surface's radius to next to the border. An error of a
// constant is an error of every field, which no bound of a sum's rounding contains.
#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/reference/reference_kernel.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace isl::reference {
namespace {

constexpr double kHardnesses[] = {0.01, 0.1, 0.5, 1, 4, 20, 60, 150, 199.6, 300, 400, 500};

/// An infinite line convolved with the window that these constants describe, by its definition: with v = w sin θ the
/// integrand is periodic and analytic, so equal steps sum it to rounding.
long double line_value(const render::KernelConstants& k, scene::KernelShape shape, long double q) {
  const long double y = q * static_cast<long double>(k.scale), w2 = 1 - y, w = std::sqrt(w2);
  const long double pi = std::acos(-1.0L), epsilon = k.a, b = 1 + epsilon;
  constexpr int kSteps = 1000;
  long double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const long double angle = pi * ((i + 0.5L) / kSteps - 0.5L), cosine = std::cos(angle);
    const long double depth = w2 * cosine * cosine, a = epsilon + 1 - depth;
    const bool is_quartic = shape == scene::KernelShape::quartic;
    sum += depth * depth * (is_quartic ? 1 : (b + 2 * a) / (a * a * b * b * b)) * w * cosine;
  }
  return static_cast<long double>(k.amplitude) * sum * pi / kSteps;
}

TEST(KernelAccuracy, EveryKernelIsTheReferencesToRoundingAtEveryHardness) {
  for (const double hardness : kHardnesses) {
    std::vector<scene::Kernel> kernels = every_kernel(hardness);
    for (const scene::Kernel& kernel : {quartic(hardness), cauchy(hardness)}) {
      kernels.push_back(convolved(kernel));
      kernels.push_back(over_sheets(kernel));
    }
    for (const scene::Kernel& kernel : kernels) {
      const render::KernelConstants constants = render::kernel_constants(kernel);
      const ReferenceKernel reference(kernel);
      for (const double of_width : {-0.75, -0.5, -0.1, 0.0, 0.3, 0.8}) {
        const double q = of_width < 0 ? 1 + of_width : 1 + of_width / (1 + hardness);
        const long double at = q, expected = reference.value(at);
        const long double sensitivity = std::abs(q * reference.slope(at));
        const long double found = kernel.mode == scene::FieldMode::convolution
                                      ? line_value(constants, kernel.shape, at)
                                      : static_cast<long double>(render::kernel_value(constants, q));
        EXPECT_LE(std::abs(found - expected), 0x1p-52L * (16 * expected + 4 * sensitivity))
            << scene::kKernelWords[static_cast<std::size_t>(kernel.shape)] << " " << hardness << ", mode "
            << static_cast<int>(kernel.mode) << ", q = " << q;
      }
    }
  }
}

}  // namespace
}  // namespace isl::reference
