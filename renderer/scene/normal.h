// Bumps: perturbations of the surface's normal.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/pattern.h"

#include <vector>

namespace isl::scene {

/// A pattern as the height of bumps. At most one of the maps is set.
struct Normal {
  Pattern pattern{};
  double bump_size = 0.5;
  double accuracy = 0.02;  ///< distance of the points whose heights are compared
  bool no_bump_scale = false;
  SlopeMapId slope_map = kNoSlopeMap;
  NormalMapId map = kNoNormalMap;  ///< other normals, chosen by the pattern
};

/// Height and slope of the bumps where the pattern has this value. Cubics interpolate between entries.
struct SlopeEntry {
  double value = 0;
  double height = 0;
  double slope = 0;
};
using SlopeMap = std::vector<SlopeEntry>;

struct NormalEntry {
  double value = 0;  ///< as PigmentEntry's
  NormalId normal = kNoNormal;
};
using NormalMap = std::vector<NormalEntry>;

}  // namespace isl::scene
