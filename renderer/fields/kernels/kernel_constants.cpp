#include "renderer/fields/kernels/kernel_constants.h"

#include "base/check.h"

#include <cmath>

namespace isl::render {

KernelConstants kernel_constants(const scene::Kernel& kernel) {
  KernelConstants constants;
  constants.shape = kernel.shape;
  if (kernel.meaning == scene::RadiusMeaning::support) {
    ISL_CHECK(kernel.shape == scene::KernelShape::quartic);
    return constants;
  }
  const double h = kernel.hardness;
  ISL_CHECK(h > 0 && h <= 500, "{}", h);
  switch (kernel.shape) {
    case scene::KernelShape::quartic:
      constants.scale = 1 / (1 + 2 / h);
      constants.amplitude = (1 + h / 2) * (1 + h / 2);
      break;
    case scene::KernelShape::gaussian: {
      const double log_cut = std::log(1 / kGaussianCut);
      const double kept = 1 - kGaussianCut * (1 + log_cut);
      constants.a = h * kept / (1 - kGaussianCut);
      constants.scale = constants.a;
      constants.support = constants.a + log_cut;
      constants.amplitude = 1 / kept;
      constants.cut = kGaussianCut;
      break;
    }
  }
  return constants;
}

}  // namespace isl::render
