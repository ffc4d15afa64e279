#include "renderer/reference/reference_kernel.h"

#include "base/check.h"
#include "renderer/reference/kernel_profiles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace isl::ISL_REFERENCE {
namespace {

constexpr ProfileInUse (*kProfiles[])(const scene::Kernel&) = {
#define ISL_KERNEL(word, Type) word##_profile,
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
};

ProfileInUse profile_of(const scene::Kernel& kernel) {
  if (kernel.mode == scene::FieldMode::convolution) return line_profile(kernel);
  if (kernel.mode == scene::FieldMode::distance) return kProfiles[static_cast<std::size_t>(kernel.shape)](kernel);
  const bool is_quartic = kernel.shape == scene::KernelShape::quartic;
  ISL_CHECK(is_quartic || kernel.shape == scene::KernelShape::cauchy, "shape {}", static_cast<int>(kernel.shape));
  return is_quartic ? cubic_profile(kernel) : cauchy_sheet_profile(kernel);
}

}  // namespace

ReferenceKernel::ReferenceKernel(const scene::Kernel& kernel) {
  ISL_CHECK(kernel.meaning == scene::RadiusMeaning::surface || kernel.shape == scene::KernelShape::quartic,
            "only the quartic has a support radius");
  ProfileInUse of = profile_of(kernel);
  profile_ = std::move(of.profile);
  support_ = of.support;
  junction_ = of.junction;
}

Jet ReferenceKernel::over(const Interval& q) const {
  if (q.lo() >= support_.hi()) return {};
  if (q.radius() <= 0x1p-30L * Interval::size(q.middle())) return at(q);
  // All three are monotone, so that their ranges are the hulls of their values at the ends.
  const Real low = std::max(q.lo(), Real(0)), high = q.hi();
  Jet range = hull(at(low), high < support_.hi() ? at(high) : Jet());
  if (junction_ && low <= junction_->hi() && high >= junction_->lo()) range = hull(range, at(*junction_));
  return range;
}

Jet ReferenceKernel::of(const Jet& q) const {
  const Jet range = over(q.value);
  return chain(range.value, range.slope, range.bend, q);
}

}  // namespace isl::ISL_REFERENCE
