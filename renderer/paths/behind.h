// The media on both sides of a surface that a path meets, and the bodies that the path is in behind it.
#pragma once

#include "renderer/paths/bodies.h"
#include "renderer/paths/path.h"
#include "renderer/shading/interiors.h"

#include <algorithm>

namespace isl::render {

struct Behind {
  double ratio = 1;          ///< the index of refraction before the surface over that behind it, for the path's light
  std::uint32_t bodies = 0;  ///< those of a path that goes on there
  bool in_solid = false;     ///< and its PathEntry::in_solid
  const Medium* before = nullptr;  ///< the media, if the surface lies between two
  const Medium* after = nullptr;

  [[nodiscard]] double ratio_of(const Wave& wave) const {
    return before ? before->ior_of(wave) / after->ior_of(wave) : 1;
  }
  /// The number of colours into which the surface parts white light.
  [[nodiscard]] int colours() const {
    const auto of = [](const Medium* medium) { return medium && medium->dispersion != 1 ? medium->colours : 1; };
    return std::max(of(before), of(after));
  }
};

/// `body` is what the surface bounds; `from_inside` tells whether the path is in it.
[[nodiscard]] inline Behind behind(const Interiors& interiors, Bodies& bodies, const PathEntry& path, const Body& body,
                                   bool from_inside) {
  const auto medium = [&](const Body* of) { return &interiors[of ? of->interior : scene::kNoInterior]; };
  const auto between = [&](const Medium* before, const Medium* after, std::uint32_t list, bool in_solid) {
    Behind there{1, list, in_solid, before, after};
    there.ratio = there.ratio_of(path.wave);
    return there;
  };
  const Medium* const own = &interiors[body.interior];
  // A new list may move the bodies, so they are asked about first.
  const Body* const last = bodies.last(path.bodies);
  const Medium* const before = medium(last);
  if (!from_inside) return between(before, own, bodies.entered(path.bodies, body), path.in_solid || !body.is_hollow);
  const bool is_last = last->id == body.id;
  const std::uint32_t list = *bodies.left(path.bodies, body.id);
  const bool in_solid = !bodies.all_are_hollow(list);
  if (is_last) return between(own, medium(bodies.last(list)), list, in_solid);
  return {.bodies = list, .in_solid = in_solid};
}

}  // namespace isl::render
