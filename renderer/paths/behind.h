// The media on both sides of a surface that a path meets, and the bodies that the path is in behind it.
#pragma once

#include "renderer/paths/bodies.h"
#include "renderer/paths/path.h"
#include "renderer/shading/interiors.h"

namespace isl::render {

struct Behind {
  double ratio = 1;          ///< the index of refraction before the surface over that behind it
  std::uint32_t bodies = 0;  ///< those of a path that goes on there
  bool in_solid = false;     ///< and its PathEntry::in_solid
};

/// `body` is what the surface bounds, and `from_inside` tells on which side of it the path comes.
[[nodiscard]] inline Behind behind(const Interiors& interiors, Bodies& bodies, const PathEntry& path, const Body& body,
                                   bool from_inside) {
  const auto ior = [&](const Body* of) { return of ? interiors[of->interior].ior : 1; };
  const double own = interiors[body.interior].ior;
  const Body* const last = bodies.last(path.bodies);
  if (!from_inside) {
    const double before = ior(last);
    return {before / own, bodies.entered(path.bodies, body), path.in_solid || !body.is_hollow};
  }
  // A path that began within the body has it not in its list.
  const bool is_last = !last || last->is_same(body);
  const std::optional<std::uint32_t> rest = bodies.left(path.bodies, body);
  const std::uint32_t list = rest.value_or(path.bodies);
  const bool was_in_it = is_last || !rest;
  return {was_in_it ? own / ior(bodies.last(list)) : 1, list, !bodies.all_are_hollow(list)};
}

}  // namespace isl::render
