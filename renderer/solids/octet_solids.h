// The solids that eight rays meet at once (octet_intervals-inl.h, first_crossings-inl.h).
#pragma once

#include "renderer/solids/solid.h"

namespace isl::render {

/// A cylinder or cone without caps.
[[nodiscard]] inline bool is_open_tube(const scene::Solid& solid) {
  return (solid.kind == scene::SolidKind::cylinder || solid.kind == scene::SolidKind::cone) && solid.open;
}

/// True if a line is inside the solid on one stretch, which inside_of() finds for eight lines. Quadrics count: lines
/// that are inside them on two stretches are rare enough to be left to crossings().
[[nodiscard]] inline bool meets_octets(const scene::Solid& solid) {
  switch (solid.kind) {
    case scene::SolidKind::plane:
    case scene::SolidKind::quadric:
    case scene::SolidKind::sphere: return true;
    case scene::SolidKind::box: return !is_open_surface(solid);
    case scene::SolidKind::cylinder:
    case scene::SolidKind::cone: return solid.a != solid.b && !solid.open;
    default: return false;
  }
}

/// True if roots_of_solid() takes the solid.
[[nodiscard]] inline bool has_octet_roots(const scene::Solid& solid) {
  return solid.kind == scene::SolidKind::cubic || solid.kind == scene::SolidKind::quartic ||
         (solid.kind == scene::SolidKind::torus && solid.radius_b <= solid.radius_a);
}

/// True if the stretches inside the solid are found for eight lines: one, or up to two of order 3 and 4.
[[nodiscard]] inline bool has_octet_stretches(const scene::Solid& solid) {
  return meets_octets(solid) || has_octet_roots(solid);
}

/// True if first_crossings() takes the solid.
[[nodiscard]] inline bool has_first_crossings(const scene::Solid& solid) {
  return has_octet_roots(solid) || solid.kind == scene::SolidKind::disc ||
         (is_open_tube(solid) && solid.a != solid.b) || meets_octets(solid);
}

}  // namespace isl::render
