// Visits the fields of a cell octet by octet. All sums over fields, along one ray or along eight, use this walk over
// runs, kernels and rows. A visitor computes the sum; its functions are
//   add_quadratics(kernel, lanes, borders)    v is a quadratic in t, everywhere or between borders
//   add_shape(kernel, constants, lanes)       a skeleton's ray form
//   add_curve(window, lanes)                  a convolved curve
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_rows-inl.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Visits the rows of convolved curves. It is out of line, so that scenes without such curves do not pay for it. The
/// visitor is passed and returned by value, so that the caller can keep it in registers.
template <class Visitor>
[[nodiscard]] HWY_NOINLINE Visitor visit_curves(const LaneRun& run, const LaneRow* row, const LaneRow* end,
                                                Visitor visitor) {
  with_window(*run.kernel, [&](const auto& window) HWY_ATTR {
    with_curve_form(run.skeleton, [&](auto type) HWY_ATTR {
      using Form = typename CurveFormOf<typename decltype(type)::type>::type;
      for (; row != end; ++row) visitor.add_curve(window, load_placed<Form>(*row));
    });
  });
  return visitor;
}

template <class Visitor>
HWY_INLINE void visit_lanes(const LaneMemory& memory, Visitor& visitor) {
  for (const LaneRun& run : memory.runs) {
    const LaneRow* row = memory.rows.data() + run.first;
    const LaneRow* const end = memory.rows.data() + run.last;
    if (run.form == LaneForm::curves) {
      visitor = visit_curves(run, row, end, visitor);
      continue;
    }
    with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR {
      Visitor own = visitor;  // the sums stay in registers
      switch (run.form) {
        case LaneForm::points:
          for (; row != end; ++row)
            own.add_quadratics(kernel, load_lanes<QuadraticLanes>(*row), everywhere(*row, *run.kernel));
          break;
        case LaneForm::pieces:
          for (; row != end; ++row) own.add_quadratics(kernel, load_lanes<QuadraticLanes>(*row), borders_of(*row));
          break;
        default:
          with_ray_form(run.skeleton, [&](auto type) HWY_ATTR {
            using Form = typename RayFormOf<typename decltype(type)::type>::type;
            for (; row != end; ++row) own.add_shape(kernel, *run.kernel, load_placed<Form>(*row));
          });
          break;
      }
      visitor = own;
    });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
