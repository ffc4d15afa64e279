// An infinite straight line, convolved: the profile by which all convolved curves are scaled, and whose support they
// have.
#include "renderer/reference/kernel_forms.h"
#include "renderer/reference/reference_window.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

class LineForm final : public KernelForm {
 public:
  explicit LineForm(const scene::Kernel& kernel) : window_(kernel) {}

  /// Its conditions are solved to a few units in the last place of a logarithm of up to 100.
  [[nodiscard]] Interval support() const override {
    return widened(window_.border(), window_.border(), 4096 * kRoundoff);
  }
  [[nodiscard]] Interval value(Real q) const override { return at(q).value; }
  [[nodiscard]] Interval slope(Real q) const override { return -(at(q).fall / Interval(window_.border())); }

 private:
  struct Value {
    Interval value, fall;
  };
  [[nodiscard]] Value at(Real q) const {
    const Real y = q / window_.border();
    if (!(y < 1)) return {0, 0};
    const ReferenceWindow::Value line = window_.line(y);
    const Real value = line.value * window_.amplitude(), fall = line.fall * window_.amplitude();
    const Real error = fall * kPlaceRounding + value * kIntegralRounding;
    // The fall is uncertain by the same share of ∫g″: near the border that is at most 13√(1 − y), for g″ ≤ 6/Y⁴ there;
    // elsewhere it is a small multiple of the fall.
    const Interval steepest = widened(fall, fall, 16384 * kRoundoff);
    const Real change = 13 * sqrt(1 - y) * window_.amplitude() * kPlaceRounding;
    return {{value - error, value + error}, {std::max(steepest.lo - change, Real(0)), steepest.hi + change}};
  }

  ReferenceWindow window_;
};

}  // namespace

KernelFormHandle line_form(const scene::Kernel& kernel) { return std::make_shared<LineForm>(kernel); }

}  // namespace isl::ISL_REFERENCE
