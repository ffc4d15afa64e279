// The formulas of φ, one function for each kernel, written once: values, slopes and bounds follow (jet.h). A new kernel
// is one more function; its word in renderer/scene/kernel_shapes.def makes it necessary here.
#pragma once

#include "renderer/reference/reference_kernel.h"

namespace isl::ISL_REFERENCE {

/// A profile with its constants. Results enclose the exact ones, because the constants are intervals too.
struct ProfileInUse {
  Profile profile;
  Interval support;
  std::optional<Interval> junction{};
};

#define ISL_KERNEL(word, Type) [[nodiscard]] ProfileInUse word##_profile(const scene::Kernel& kernel);
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL

/// The kernels of the modes sheet and convolution: for planes and for infinite lines that are convolved.
[[nodiscard]] ProfileInUse cauchy_sheet_profile(const scene::Kernel& kernel);
[[nodiscard]] ProfileInUse line_profile(const scene::Kernel& kernel);

/// The distance Q − q to the end of the support over that at q = 1: 1 + (1 − q)·fall, where fall is 1/(Q − 1). It
/// counts from q = 1, because near there Q − q of a hard kernel would cancel.
[[nodiscard]] inline Jet depth_at(const Jet& q, const Interval& fall) { return (Interval(1) - q) * fall + Interval(1); }

/// The last place from `from` towards `to` where f certainly has this sign, if it has it at `from`; to neighbouring
/// numbers.
template <class Function>
[[nodiscard]] Real last_certain(const Function& f, Real from, Real to, int sign) {
  while (true) {
    const Real middle = from + (to - from) / 2;
    if (middle == from || middle == to) return from;
    (f(middle).sign() == sign ? from : to) = middle;
  }
}
/// The place between low and high where a falling function of intervals passes zero.
template <class Function>
[[nodiscard]] Interval zero_of_falling(const Function& f, Real low, Real high) {
  return {last_certain(f, low, high, 1), last_certain(f, high, low, -1)};
}

}  // namespace isl::ISL_REFERENCE
