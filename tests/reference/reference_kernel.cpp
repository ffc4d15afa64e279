#include "tests/reference/reference_kernel.h"

#include "base/check.h"

namespace isl::reference {
namespace {

/// Where the exponential is cut, as a fraction of its value at q = 1.
constexpr long double kDelta = 1e-3L;

/// glibc's expl and expm1l are good to one unit in the last place; this leaves room for sixteen.
constexpr long double kLibraryError = 0x1p-60L;

/// eˣ − 1 − x for x ≥ 0. Below 1 the difference cancels, so there it is the series.
long double exponential_remainder(long double x) {
  if (x > 1) return std::expm1(x) - x;
  long double term = x * x / 2, sum = 0;
  for (int k = 3; k < 30; ++k) {
    sum += term;
    term *= x / k;
  }
  return sum;
}

}  // namespace

ReferenceKernel::ReferenceKernel(const scene::Kernel& kernel) : shape_(kernel.shape) {
  const Interval hardness(kernel.hardness);
  if (kernel.meaning == scene::RadiusMeaning::support) {
    ISL_CHECK(shape_ == scene::KernelShape::quartic, "only the quartic has a support radius");
    support_ = rate_ = 1;
  } else if (shape_ == scene::KernelShape::quartic) {
    support_ = Interval(1) + Interval(2) / hardness;
    rate_ = hardness * Interval(0.5L);
  } else {
    const Interval log_delta = widened(std::log(1 / kDelta), std::log(1 / kDelta), kLibraryError);
    const Interval rest = Interval(1) - Interval(kDelta) * (Interval(1) + log_delta);
    rate_ = hardness * rest / (Interval(1) - Interval(kDelta));
    support_ = Interval(1) + log_delta / rate_;
    amplitude_ = Interval(kDelta) / rest;
  }
}

Interval ReferenceKernel::depth(const Interval& q) const {
  const Interval x = rate_ * (support_ - q);
  return {std::max(x.lo, 0.0L), std::max(x.hi, 0.0L)};
}

Interval ReferenceKernel::value(const Interval& q) const {
  const Interval x = depth(q);
  if (shape_ == scene::KernelShape::quartic) return square(x);
  return amplitude_ * widened(exponential_remainder(x.lo), exponential_remainder(x.hi), kLibraryError);
}

Interval ReferenceKernel::slope(const Interval& q) const {
  const Interval x = depth(q);
  if (shape_ == scene::KernelShape::quartic) return -(Interval(2) * rate_ * x);
  return -(rate_ * amplitude_ * widened(std::expm1(x.lo), std::expm1(x.hi), kLibraryError));
}

}  // namespace isl::reference
