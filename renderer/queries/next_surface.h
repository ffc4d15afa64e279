// The next surface of an object behind a point that may itself lie on it. This is the answer to `trace`.
//
// A point that `trace` returned lies on a surface up to rounding, and a ray from there may cross that surface at once.
// The surface's place is known no better than the face's rounding (trace/face.h), computed from the coordinates of the
// point and of the object alone: a ray that comes from far away is taken up again near its hit, so that the length of
// its way does not count.
//   - A surface that lies no farther than 4 roundings from the start is the start itself, and is passed: the walk
//     continues from the crossing, whose root is then known and divided out as that of a secondary ray is. Distances
//     are across the surface, t |n·d|, since a grazing ray goes far within them.
//   - Two crossings of one solid, blob or combination, in and out again or out and in, between which the ray gets no
//     farther than 16 roundings from the surface, are dropped together. So a crossing that is returned has no other
//     within the distance that counts as the start, and a walk from crossing to crossing finds each exactly once: the
//     number of crossings that it finds is even exactly if their true number is.
// A start counts 4 roundings, because the point was rounded when it was found and the crossing is when it is found
// again, each by one rounding at a distance of up to two sizes of its coordinates. The 16 roundings leave as much again
// between the two rules.
#pragma once

#include "renderer/trace/tracer.h"

#include <optional>

namespace isl::render {

struct NextSurface {
  Ray ray;
  Hit hit;                 ///< hit of that ray; a miss if there is no surface
  bool is_certain = true;  ///< every ray of the walk was certified
};

/// The first surface beyond `origin`. `origin` and `direction` are in the space that `parent_from_object` leads to; the
/// result is in the object's space. The tracer is the object's own, with the solver `exact`.
[[nodiscard]] NextSurface next_surface(const Tracer& tracer, const scene::Transform& parent_from_object,
                                       const Vec3& origin, const Vec3& direction);

}  // namespace isl::render
