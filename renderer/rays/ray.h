// Rays and hits: the types that tracing, shading and queries share.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace isl::render {

using scene::Vec3;

/// Number of an instance: one placed solid or blob of the flattened scene. scene::kNone is "none".
using InstanceId = std::uint32_t;

/// The surface a secondary ray starts on, so that its root at t = 0 is known and not searched for.
struct RayStart {
  InstanceId instance = scene::kNone;
  std::uint32_t part = 0;             ///< for a solid: which of its surfaces (Hit::part)
  std::uint32_t leaf = scene::kNone;  ///< for a CSG tree: which of its leaves (Hit::leaf)

  friend bool operator==(const RayStart&, const RayStart&) = default;
};

/// The purpose of a ray. Objects may be hidden from some kinds; the values are bits, so that one number holds a set of
/// kinds.
enum class RayKind : std::uint8_t {
  image = 1,       ///< from the camera, with no reflection on the way
  reflection = 2,  ///< with a reflection on the way from the camera
  shadow = 4,
  around = 8,  ///< for light that comes to a point from around: occlusion, the sky, other surfaces
  query = 0,   ///< for a question about the scene: meets every object
};

/// A half-line in world space. The direction has unit length. A ray with NaN or infinite entries, or a zero direction,
/// meets nothing.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double t_max = std::numeric_limits<double>::infinity();  ///< hits beyond it do not count (a light's distance)
  double path_length = 0;  ///< from the eye to the origin; together with the pixel's angle it gives the footprint
  RayStart start;
};

/// Bits that are added to a kind: the ray meets only objects that let no light through, or only those that may.
inline constexpr std::uint8_t kOnlyOpaque = 16, kOnlyClear = 32;
[[nodiscard]] constexpr RayKind with(RayKind kind, std::uint8_t only) {
  return static_cast<RayKind>(static_cast<std::uint8_t>(kind) | only);
}

/// How sure the answer of a ray is. Greater is worse.
enum class Certainty : std::uint8_t {
  certified,  ///< proved: this is the first surface, or there is none
  undecided,  ///< on the way F stays so close to the threshold that no digits at hand decide on which side it is
  refuted,    ///< a check shows that no surface lies where one was found, within the tolerance
};

inline void lower(Certainty& certainty, Certainty to) { certainty = std::max(certainty, to); }

/// The answer of a shadow ray.
enum Occlusion : std::uint8_t {
  kUnoccluded,
  kOccluded,
  kUndecidedOcclusion,  ///< nothing was found, and that is undecided
};

/// The nearest surface on a ray. `instance` is scene::kNone for a miss.
struct Hit {
  double t = std::numeric_limits<double>::infinity();
  InstanceId instance = scene::kNone;
  std::uint32_t cell = scene::kNone;  ///< for a blob: the cell whose list holds every component that matters at the
                                      ///< hit; for `paper` and `iso` with reuse, a number known to the thread that
                                      ///< found it
  std::uint32_t part = 0;             ///< for a solid: which of its surfaces
  bool from_inside = false;           ///< the ray came out of the object rather than into it; false for a solid that is
                                      ///< no part of a group, unless the ray is a query
  std::uint32_t leaf = scene::kNone;  ///< for a CSG tree: which of its leaves
  Certainty certainty = Certainty::certified;

  [[nodiscard]] bool is_miss() const { return instance == scene::kNone; }
  /// The start of a ray that continues from this hit.
  [[nodiscard]] RayStart start() const { return {instance, part, leaf}; }
};

/// The rest of a ray beyond a hit.
[[nodiscard]] inline Ray continued(const Ray& ray, const Hit& hit) {
  return {.origin = ray.origin + ray.direction * hit.t,
          .direction = ray.direction,
          .t_max = ray.t_max - hit.t,
          .path_length = ray.path_length + hit.t,
          .start = hit.start()};
}

/// One of several hits of a ray at one place.
struct CoincidingHit {
  const Ray* ray;
  Hit hit;
};

/// The answer of a shadow ray with this hit.
[[nodiscard]] inline Occlusion occlusion_of(const Hit& hit) {
  if (!hit.is_miss()) return kOccluded;
  return hit.certainty == Certainty::certified ? kUnoccluded : kUndecidedOcclusion;
}

}  // namespace isl::render
