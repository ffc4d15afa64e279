// The shapes of φ, one form each: the formulas of φ and φ′ at a single q, and the constants that follow from its
// conditions. reference_kernel uses the forms and has everything that they share. A new kernel is one more form; its
// word in renderer/scene/kernel_shapes.def makes it necessary here.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/scene/database.h"

#include <algorithm>
#include <memory>

namespace isl::ISL_REFERENCE {

/// φ within its support. Every result encloses the exact one, because the constants are intervals too.
class KernelForm {
 public:
  virtual ~KernelForm() = default;
  /// Q, the end of the support.
  [[nodiscard]] virtual Interval support() const = 0;
  /// φ and dφ/dq at 0 ≤ q < support().hi.
  [[nodiscard]] virtual Interval value(Real q) const = 0;
  [[nodiscard]] virtual Interval slope(Real q) const = 0;
};

using KernelFormHandle = std::shared_ptr<const KernelForm>;

#define ISL_KERNEL(word, Type) [[nodiscard]] KernelFormHandle word##_form(const scene::Kernel& kernel);
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL

/// The kernels of the modes sheet and convolution: for planes and for infinite lines that are convolved.
[[nodiscard]] KernelFormHandle cauchy_sheet_form(const scene::Kernel& kernel);
[[nodiscard]] KernelFormHandle line_form(const scene::Kernel& kernel);

/// The argument of a form's φ: it falls along a straight line through its value at q = 1, and reaches zero at Q. It
/// counts from q = 1, because near there Q − q of a hard kernel would cancel.
struct Depth {
  Interval at_one, rate;

  [[nodiscard]] Interval at(Real q) const {
    const Interval depth = at_one + rate * (Interval(1) - Interval(q));
    return {std::max(depth.lo, Real(0)), std::max(depth.hi, Real(0))};
  }
};

/// glibc's exponentials and logarithms are correct to a few units in the last place, 2·kRoundoff each; this allows
/// eight of them.
inline constexpr Real kLibraryError = 16 * kRoundoff;

}  // namespace isl::ISL_REFERENCE
