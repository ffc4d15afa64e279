#include "renderer/extended/extended_kernel.h"

#include "base/check.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <tuple>

namespace isl::ISL_EXTENDED {
namespace {

constexpr KernelFormHandle (*kForms[])(const scene::Kernel&) = {
#define ISL_KERNEL(word, Type) word##_form,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

KernelFormHandle make_form(const scene::Kernel& kernel) {
  if (kernel.mode == scene::FieldMode::convolution) return line_form(kernel);
  if (kernel.mode == scene::FieldMode::distance) return kForms[static_cast<std::size_t>(kernel.shape)](kernel);
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  return is_quartic ? cubic_form(kernel) : cauchy_sheet_form(kernel);
}

/// Forms are kept, because solving for the constants of one takes as long as searching a ray.
KernelFormHandle form_of(const scene::Kernel& kernel) {
  static std::mutex mutex;
  static std::map<std::tuple<scene::KernelShape, scene::RadiusMeaning, scene::FieldMode, double>, KernelFormHandle>
      made;
  const std::lock_guard lock(mutex);
  KernelFormHandle& form = made[{kernel.shape, kernel.meaning, kernel.mode, kernel.hardness}];
  if (!form) form = make_form(kernel);
  return form;
}

}  // namespace

ExtendedKernel::ExtendedKernel(const scene::Kernel& kernel) : form_(form_of(kernel)), support_(form_->support()) {
  ISL_CHECK(kernel.meaning == scene::RadiusMeaning::surface || kernel.shape == scene::KernelShape::quartic,
            "only the quartic has a support radius");
}

Interval ExtendedKernel::value(const Interval& q) const {
  const auto at = [this](Real one) { return one < support_.hi ? form_->value(one) : Interval(0); };
  return {at(q.hi).lo, at(q.lo).hi};
}

Interval ExtendedKernel::slope(const Interval& q) const {
  const auto at = [this](Real one) { return one < support_.hi ? form_->slope(one) : Interval(0); };
  return {at(q.lo).lo, at(q.hi).hi};
}

}  // namespace isl::ISL_EXTENDED
