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
#include <cmath>
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
template <class Setup>
HWY_INLINE void gather_fields(Setup& setup, LaneMemory& memory, const ComponentTable& table, const std::uint32_t* items,
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
    if (setup.rows() > first)
      memory.runs.push_back({&group.kernel, form, group.skeleton, first, setup.rows(), group.surface_alone});
    next = last;
  }
}

/// The part of PlacedLine that a row keeps.
template <class N>
struct Placement {
  N start;  ///< t
  N size;   ///< the greatest coordinate that positions on the skeleton are computed from
};

/// A ray in a component's own space, from where it is nearest to the component's middle.
struct PlacedLine {
  Vec3 origin, direction;
  double start = 0;
  double size;  ///< the greatest coordinate of `origin` and of what it was computed from

  PlacedLine(const ListedFields& fields, std::uint32_t item, const Vec3& o, const Vec3& d) : origin(o), direction(d) {
    const ComponentTable& table = fields.table;
    const Vec3 centre(table.x[item], table.y[item], table.z[item]);
    const scene::Transform* const map =
        fields.group.is_mapped ? &table.blob_from_component(fields.group, item) : nullptr;
    if (map) {
      direction = map->inverse_vector(d);
      origin = map->inverse_point(o);
    }
    // The origin of an endless component is any point of its plane, and may be far from where the ray meets it.
    if (!scene::is_endless(fields.group.skeleton)) {
      const double t = (centre - origin).dot(direction) / direction.length2();
      if (std::isfinite(t)) start = t;
      const Vec3 nearest = o + d * start;
      origin = map ? map->inverse_point(nearest) : nearest;
    }
    size = (origin - centre).length();
    if (map) size += map->inverse_terms(o + d * start);
  }
};

/// Results of laying out the fields for a stretch of a ray, or for eight.
template <class Count, class Number>
struct SetupSums {
  Count field_count;  ///< number of fields that reach the stretch
  Number peak;        ///< upper bound of the sum on the stretch, without rounding
  Number moved;       ///< how much the sum of points of plain kernels changes if positions are off by their sizes
  double exponent;    ///< the greatest v within the support of any field: scales the exponential's error

  HWY_INLINE SetupSums() : field_count(0), peak(0.0), moved(0.0), exponent(0) {}
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
