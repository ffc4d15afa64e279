// All kernels, and the ways to get from a kernel's constants to the code that evaluates it.
#if defined(ISL_RENDERER_FIELDS_KERNELS_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_KERNELS_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_KERNELS_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_KERNELS_INL_H_
#endif

#include "renderer/fields/kernels/cauchy-inl.h"
#include "renderer/fields/kernels/cubic-inl.h"
#include "renderer/fields/kernels/gaussian-inl.h"
#include "renderer/fields/kernels/metaball-inl.h"
#include "renderer/fields/kernels/quartic-inl.h"
#include "renderer/fields/kernels/sheet_cauchy-inl.h"
#include "renderer/fields/kernels/soft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Calls `use` with the kernel of these constants.
template <class Use>
HWY_INLINE void with_each_kernel(const KernelConstants& constants, Use&& use) {
  if (constants.is_sheet) {
    if (constants.shape == scene::KernelShape::quartic) return use(Cubic(constants));
    return use(CauchySheet(constants));
  }
  switch (constants.shape) {
#define ISL_KERNEL(word, Type)   \
  case scene::KernelShape::word: \
    use(Type(constants));        \
    break;
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
  }
}

// GCC does not see that with_each_kernel() calls its function for every shape.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

/// Any kernel, chosen anew at every call: for the kernels that do not get an inner loop of their own.
class AnyKernel {
 public:
  explicit AnyKernel(const KernelConstants& constants) : constants_(constants) {}

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(constants_.support); }
  [[nodiscard]] HWY_NOINLINE Octet value(const Octet& v) const {
    Octet result;
    with_each_kernel(constants_, [&](const auto& kernel) HWY_ATTR { result = kernel.value(v); });
    return result;
  }
  [[nodiscard]] HWY_NOINLINE KernelValue value_and_slope(const Octet& v) const {
    KernelValue result;
    with_each_kernel(constants_, [&](const auto& kernel) HWY_ATTR { result = kernel.value_and_slope(v); });
    return result;
  }
  [[nodiscard]] HWY_NOINLINE Octet curvature(const Octet& v) const {
    Octet result;
    with_each_kernel(constants_, [&](const auto& kernel) HWY_ATTR { result = kernel.curvature(v); });
    return result;
  }
  [[nodiscard]] HWY_NOINLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    OctetMask result;
    with_each_kernel(constants_, [&](const auto& kernel) HWY_ATTR { result = kernel.is_smooth(v_low, v_high); });
    return result;
  }
  [[nodiscard]] HWY_NOINLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                          const Octet& u_far) const {
    SecondAndFourth result;
    with_each_kernel(constants_,
                     [&](const auto& kernel) HWY_ATTR { result = kernel.on_quadratic(v0, kappa, u_near, u_far); });
    return result;
  }
  [[nodiscard]] HWY_NOINLINE SlopeBounds slopes(const Octet& v_least) const {
    SlopeBounds result;
    with_each_kernel(constants_, [&](const auto& kernel) HWY_ATTR { result = kernel.slopes(v_least); });
    return result;
  }

 private:
  const KernelConstants& constants_;
};
#pragma GCC diagnostic pop

/// Like with_each_kernel(), for inner loops. The two kernels that most scenes use are compiled into the loop; the
/// others share one version of it, which halves the compile time and costs them one branch for each octet.
template <class Use>
HWY_INLINE void with_kernel(const KernelConstants& constants, Use&& use) {
  if (constants.is_sheet) return use(AnyKernel(constants));
  switch (constants.shape) {
    case scene::KernelShape::quartic: use(Quartic(constants)); break;
    case scene::KernelShape::gaussian: use(Gaussian(constants)); break;
    default: use(AnyKernel(constants)); break;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
