#include "renderer/solvers/cells/extended_search.h"

#include "renderer/fields/component_table.h"
#include "renderer/solvers/cells/stretch_search.h"

namespace isl::render {
namespace {

/// True if 113 bits may decide what long double does not. They do not help a convolution: it is integrated to 2⁻⁵⁷,
/// whatever the type.
bool gains_by_more_digits(const LaidOutFields& fields) {
  const ComponentTable& table = *fields.table;
  for (std::uint32_t i = 0; i < fields.count; ++i) {
    const scene::Component& component = table.blob->components[table.source[fields.items[i]]];
    if (table.database->kernels[index(component.kernel)].mode == scene::FieldMode::convolution) return false;
  }
  return true;
}

}  // namespace

std::optional<bool> is_inside(const LaidOutFields& fields, double t) {
  const std::optional<bool> inside = reference::is_inside_at(fields, t);
  return inside || !gains_by_more_digits(fields) ? inside : wide_reference::is_inside_at(fields, t);
}

bool may_cross(const LaidOutFields& fields, double t0, double t1) { return reference::may_cross_on(fields, t0, t1); }

ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch) {
  const ExtendedAnswer answer = reference::search_stretch(fields, stretch);
  return answer.is_certain || !gains_by_more_digits(fields) ? answer : wide_reference::search_stretch(fields, stretch);
}

}  // namespace isl::render
