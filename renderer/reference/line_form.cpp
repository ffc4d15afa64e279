// An infinite straight line, convolved: the profile by which all convolved curves are scaled, and whose support they
// have.
#include "renderer/reference/kernel_forms.h"
#include "renderer/reference/reference_window.h"

namespace isl::ISL_REFERENCE {
namespace {

class LineForm final : public KernelForm {
 public:
  explicit LineForm(const scene::Kernel& kernel) : window_(kernel) {}

  /// Its conditions are solved to a few units in the last place; this allows a hundred or so.
  [[nodiscard]] Interval support() const override { return widened(window_.border(), window_.border(), 0x1p-52L); }
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
    // 1 − y is known to a unit in the last place of 1, so the value is uncertain by that share of its fall.
    return {{value - fall * 0x1p-60L, value + fall * 0x1p-60L}, widened(fall, fall, 0x1p-50L)};
  }

  ReferenceWindow window_;
};

}  // namespace

KernelFormHandle line_form(const scene::Kernel& kernel) { return std::make_shared<LineForm>(kernel); }

}  // namespace isl::ISL_REFERENCE
