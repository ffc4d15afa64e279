// Blinn's exponential minus its tangent at q = Q, where it has fallen to δ = 10⁻³ of its value at q = 1:
//   φ = δ(eˣ − 1 − x)/(1 − δ(1 + ln 1/δ)),   x = a(Q − q) = ln 1/δ + a(1 − q),   Q = 1 + ln(1/δ)/a,
// where φ′(1) = −h requires a = h(1 − δ(1 + ln 1/δ))/(1 − δ).
#include "renderer/reference/kernel_forms.h"

namespace isl::ISL_REFERENCE {
namespace {

constexpr Real kDelta = Real(1) / 1000;

/// Later terms add nothing to the series of eˣ for x ≤ 1: 1/29! is 2⁻¹⁰², and 1/39! is 2⁻¹⁵³.
constexpr int kTerms = kDigits > 64 ? 40 : 30;

/// eˣ − 1 − x for x ≥ 0. Below 1 the difference cancels, so the series is used there.
Real exponential_remainder(Real x) {
  if (x > 1) return expm1(x) - x;
  Real term = x * x / 2, sum = 0;
  for (int k = 3; k < kTerms; ++k) {
    sum += term;
    term *= x / k;
  }
  return sum;
}

class GaussianForm final : public KernelForm {
 public:
  explicit GaussianForm(const scene::Kernel& kernel) {
    const Interval log_delta = widened(log(1 / kDelta), log(1 / kDelta), kLibraryError);
    const Interval rest = Interval(1) - Interval(kDelta) * (Interval(1) + log_delta);
    depth_ = {log_delta, Interval(kernel.hardness) * rest / (Interval(1) - Interval(kDelta))};
    amplitude_ = Interval(kDelta) / rest;
  }
  [[nodiscard]] Interval support() const override { return Interval(1) + depth_.at_one / depth_.rate; }
  [[nodiscard]] Interval value(Real q) const override {
    const Interval x = depth_.at(q);
    return amplitude_ * widened(exponential_remainder(x.lo), exponential_remainder(x.hi), kLibraryError);
  }
  [[nodiscard]] Interval slope(Real q) const override {
    const Interval x = depth_.at(q);
    return -(depth_.rate * amplitude_ * widened(expm1(x.lo), expm1(x.hi), kLibraryError));
  }

 private:
  Depth depth_;  ///< x
  Interval amplitude_;
};

}  // namespace

KernelFormHandle gaussian_form(const scene::Kernel& kernel) { return std::make_shared<GaussianForm>(kernel); }

}  // namespace isl::ISL_REFERENCE
