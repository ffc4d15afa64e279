#include "renderer/reference/reference_kernel.h"

#include "base/check.h"

#include <cstddef>

namespace isl::ISL_REFERENCE {
namespace {

constexpr KernelFormHandle (*kForms[])(const scene::Kernel&) = {
#define ISL_KERNEL(word, Type) word##_form,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

KernelFormHandle form_of(const scene::Kernel& kernel) {
  if (kernel.mode == scene::FieldMode::convolution) return line_form(kernel);
  if (kernel.mode == scene::FieldMode::distance) return kForms[static_cast<std::size_t>(kernel.shape)](kernel);
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  return is_quartic ? cubic_form(kernel) : cauchy_sheet_form(kernel);
}

}  // namespace

ReferenceKernel::ReferenceKernel(const scene::Kernel& kernel) : form_(form_of(kernel)), support_(form_->support()) {
  ISL_CHECK(kernel.meaning == scene::RadiusMeaning::surface || kernel.shape == scene::KernelShape::quartic,
            "only the quartic has a support radius");
}

Interval ReferenceKernel::value(const Interval& q) const {
  const auto at = [this](Real one) { return one < support_.hi ? form_->value(one) : Interval(0); };
  return {at(q.hi).lo, at(q.lo).hi};
}

Interval ReferenceKernel::slope(const Interval& q) const {
  const auto at = [this](Real one) { return one < support_.hi ? form_->slope(one) : Interval(0); };
  return {at(q.lo).lo, at(q.hi).hi};
}

}  // namespace isl::ISL_REFERENCE
