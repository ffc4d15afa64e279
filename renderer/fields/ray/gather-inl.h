// Walks a cell's list group by group and passes each group to the setup by its form along a ray: points, pieces, a ray
// form, or a convolved curve. The setup lays the fields out: LaneSetup for one ray, PacketSetup for eight.
#if defined(ISL_RENDERER_FIELDS_RAY_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_GATHER_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_GATHER_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_GATHER_INL_H_
#endif

#include "renderer/fields/component_table.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_rows-inl.h"

#include <algorithm>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Entries of a list that belong to one group.
struct ListedFields {
  const ComponentTable& table;
  const FieldGroup& group;
  const std::uint32_t* items;
  std::uint32_t count;
};

/// Calls one of the setup's functions for every group of `items`, which ascend,
///   add_points(kernel, fields)
///   add_pieces(kernel, fields)
///   add_shapes<Shape>(kernel, fields)
///   add_curves(fields)
/// and makes a run of the rows that the call adds.
template <class Setup, class Memory>
HWY_INLINE void gather_fields(Setup& setup, Memory& memory, const ComponentTable& table, const std::uint32_t* items,
                              std::uint32_t count) {
  memory.runs.clear();
  for (std::uint32_t next = 0; next < count;) {
    const FieldGroup& group = table.group_of(items[next]);
    std::uint32_t last = next + 1;
    if (items[count - 1] < group.end) {
      last = count;
    } else {
      while (last < count && items[last] < group.end) ++last;
    }
    const ListedFields fields{table, group, items + next, last - next};
    const std::uint32_t first = setup.rows();
    LaneForm form = LaneForm::curves;
    if (group.kernel.is_convolved) {
      setup.add_curves(fields);
    } else {
      with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
        if (group.skeleton == scene::Skeleton::point && !group.is_mapped) {
          form = LaneForm::points;
          setup.add_points(kernel, fields);
          return;
        }
        form = LaneForm::pieces;
        with_ray_form(group.skeleton, [&](auto type) HWY_ATTR {
          form = LaneForm::shapes;
          setup.template add_shapes<typename decltype(type)::type>(kernel, fields);
        });
        if (form == LaneForm::pieces) setup.add_pieces(kernel, fields);
      });
    }
    if (setup.rows() > first) memory.runs.push_back({&group.kernel, form, group.skeleton, first, setup.rows()});
    next = last;
  }
}

/// Results of laying out the fields for a stretch of a ray, or for eight.
template <class Count, class Number>
struct SetupSums {
  Count field_count;  ///< number of fields that reach the stretch
  Number peak;        ///< upper bound of the sum on the stretch, without rounding
  double exponent;    ///< the greatest v within the support of any field: scales the exponential's error

  HWY_INLINE SetupSums() : field_count(0), peak(0.0), exponent(0) {}
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
