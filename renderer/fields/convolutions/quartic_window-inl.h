// The quartic as a window to integrate: g(y) = (1 − y)², y = the squared distance in support radii.
//
// Along a ray past a fixed point, with e = (p − s)·D, y′ = 2e and y″ = 2D²:
//   g″ = 8e² − 4D²(1 − y),  g‴ = 24eD²,  g⁗ = 24D⁴.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_QUARTIC_WINDOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_QUARTIC_WINDOW_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_QUARTIC_WINDOW_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_QUARTIC_WINDOW_INL_H_
#endif

#include "renderer/fields/convolutions/window_bounds-inl.h"
#include "renderer/fields/kernels/kernel_constants.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct QuarticWindow {
  HWY_INLINE explicit QuarticWindow(const KernelConstants&) {}

  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& y) const {
    const N w = N(1.0) - y;
    return w * w;
  }
  [[nodiscard]] HWY_INLINE double second_at_border() const { return 2; }
  [[nodiscard]] HWY_INLINE double third_at_border() const { return 0; }

  [[nodiscard]] HWY_INLINE WindowBounds bounds(const Octet& y_least, const Octet& e2, const Octet& speed2) const {
    return {Octet(-4.0) * speed2 * (Octet(1.0) - y_least), Octet(8.0) * e2, Octet(24.0) * speed2 * sqrt(e2),
            Octet(24.0) * speed2 * speed2};
  }
  /// The whole length: the window is as wide as the support.
  [[nodiscard]] HWY_INLINE Octet effective_length(const Octet& length, const Octet&, const Octet&) const {
    return length;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
