#include "renderer/fields/kernels/kernel_constants.h"

#include "base/check.h"
#include "renderer/fields/kernels/curve_constants.h"
#include "renderer/fields/kernels/kernels-inl.h"

namespace isl::render {
namespace {

KernelConstants sheet_constants(const scene::Kernel& kernel) {
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  KernelConstants constants = is_quartic ? HWY_NAMESPACE::Cubic::constants(kernel.hardness)
                                         : HWY_NAMESPACE::CauchySheet::constants(kernel.hardness);
  constants.shape = kernel.shape;
  constants.is_sheet = true;
  return constants;
}

}  // namespace

KernelConstants kernel_constants(const scene::Kernel& kernel) {
  if (kernel.mode == scene::FieldMode::convolution) return curve_constants(kernel);
  KernelConstants constants;
  if (kernel.meaning == scene::RadiusMeaning::support) {
    ISL_CHECK(kernel.shape == scene::KernelShape::quartic, "shape {}", static_cast<int>(kernel.shape));
    return constants;
  }
  ISL_CHECK(kernel.hardness > 0 && kernel.hardness <= 500, "{}", kernel.hardness);
  if (kernel.mode == scene::FieldMode::sheet) return sheet_constants(kernel);
  switch (kernel.shape) {
#define ISL_KERNEL(word, Type)                                   \
  case scene::KernelShape::word:                                 \
    constants = HWY_NAMESPACE::Type::constants(kernel.hardness); \
    break;
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
  }
  constants.shape = kernel.shape;
  return constants;
}

double kernel_profile(const KernelConstants& constants, double v) {
  if (!(v < constants.support)) return 0;
  double value = 0;
  HWY_NAMESPACE::with_each_kernel(constants, [&](const auto& kernel) { value = kernel.value(v); });
  return value;
}

std::optional<double> passing_argument(const KernelConstants& constants, double amplitude, double threshold) {
  if (!(amplitude * kernel_profile(constants, 0) > threshold)) return std::nullopt;
  double inside = 0, outside = constants.support;
  for (double middle = 0.5 * outside; middle > inside && middle < outside; middle = inside + 0.5 * (outside - inside)) {
    (amplitude * kernel_profile(constants, middle) > threshold ? inside : outside) = middle;
  }
  return inside;
}

double kernel_slope(const KernelConstants& constants, double v) {
  if (!(v < constants.support)) return 0;
  using HWY_NAMESPACE::kOctet;
  alignas(64) double slope[kOctet] = {};
  HWY_NAMESPACE::with_each_kernel(constants, [&](const auto& kernel) {
    HWY_NAMESPACE::store(kernel.value_and_slope(HWY_NAMESPACE::Octet(v)).slope, slope);
  });
  return slope[0];
}

}  // namespace isl::render
