// The shapes of φ, one form each: the formulas of φ and φ′ at a single q, and the constants that its conditions leave.
// Behind reference_kernel, which knows what all of them have in common. A new kernel is one more form: its word in
// renderer/scene/kernel_shapes.def asks for it here.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/interval.h"

#include <algorithm>
#include <memory>

namespace isl::reference {

/// φ within its support. Every answer encloses the exact one, for the constants are intervals too.
class KernelForm {
 public:
  virtual ~KernelForm() = default;
  /// Q.
  [[nodiscard]] virtual Interval support() const = 0;
  /// φ and dφ/dq at 0 ≤ q < support().hi.
  [[nodiscard]] virtual Interval value(long double q) const = 0;
  [[nodiscard]] virtual Interval slope(long double q) const = 0;
};

using KernelFormHandle = std::shared_ptr<const KernelForm>;

#define ISL_KERNEL(word, Type) [[nodiscard]] KernelFormHandle word##_form(const scene::Kernel& kernel);
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL

/// Of planes and of infinite lines that are convolved: the kernels of the modes sheet and convolution.
[[nodiscard]] KernelFormHandle cauchy_sheet_form(const scene::Kernel& kernel);
[[nodiscard]] KernelFormHandle line_form(const scene::Kernel& kernel);

/// What a form's φ is a function of: it falls along a straight line through its value at q = 1, and has reached zero at
/// Q. Counted from q = 1, since near there Q − q of a hard kernel would cancel.
struct Depth {
  Interval at_one, rate;

  [[nodiscard]] Interval at(long double q) const {
    const Interval depth = at_one + rate * (Interval(1) - Interval(q));
    return {std::max(depth.lo, 0.0L), std::max(depth.hi, 0.0L)};
  }
};

/// glibc's exponentials and logarithms of long doubles are good to a few units in the last place, 2⁻⁶³ each; this
/// leaves room for eight.
inline constexpr long double kLibraryError = 0x1p-60L;

}  // namespace isl::reference
