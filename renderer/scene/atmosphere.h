// The sky, which rays that hit nothing see, and the fog and rainbows in front of what is seen.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/colour.h"
#include "renderer/scene/pigment.h"
#include "renderer/scene/said_at.h"
#include "renderer/scene/warp.h"

#include <vector>

namespace isl::scene {

/// Pigments evaluated at the ray's direction, the first at the bottom.
struct SkySphere {
  std::vector<Pigment> pigments;
  Colour emission{1, 1, 1};
  TransformId world_from_sky = kIdentity;
  OriginId origin{};
};

/// Items whose places are kept.
enum class FogItem : std::uint8_t { type, turbulence, count };

struct Fog {
  enum class Kind : std::uint8_t { constant, ground };
  Kind kind = Kind::constant;
  Colour colour{};
  double distance = 0;  ///< at which the fog lets 1/e of the light through; 0: no fog
  Turbulence turbulence;
  double turbulence_depth = 0.5;
  double offset = 0;    ///< ground: below this height the fog is constant
  double altitude = 0;  ///< ground: scale height of the thinning above `offset`
  Vec3 up{0, 1, 0};     ///< of unit length
  SaidAt<FogItem> said_at{};
  OriginId origin{};
};

/// Angles in radians.
struct Rainbow {
  Vec3 direction{0};  ///< of the light, of unit length
  Vec3 up{0, 1, 0};   ///< of unit length, at a right angle to the direction
  double angle = 0;
  double width = 0;
  double distance = 0;
  double jitter = 0;
  double arc_angle = 0;
  double falloff_angle = 0;
  PigmentMapId colours = kNoPigmentMap;  ///< from the innermost ring to the outermost
  OriginId origin{};
};

}  // namespace isl::scene
