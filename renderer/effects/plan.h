// Which effects a scene calls for. Asked once, before rendering: an effect that is not in the plan has no queue and
// costs nothing. What else the plan is for: `isl plan` and --stats name the effects and what asked for them.
#pragma once

#include "renderer/scene/database.h"

#include <string>
#include <vector>

namespace isl::render {

/// An effect by name, why it is called for or left out (lower case, no full stop), and what in the scene asked for it;
/// no origin where nothing in particular did.
struct PlannedEffect {
  std::string name;
  std::string reason;
  OriginId origin;
};

struct Plan {
  bool plain_colours = false;  ///< the quality asks for pigments as they are, without any light
  bool lighting = false;       ///< some light shines: diffuse light
  bool shadows = false;        ///< some light throws shadows and something can stand in its way
  bool highlights = false;     ///< some texture has phong or specular, and a light makes them
  std::vector<PlannedEffect> called_for;
  std::vector<PlannedEffect> left_out;
};

/// `quality` as POV-Ray's +Q: 0 and 1 plain pigments only; 2 and 3 light without shadows; 4 and up everything.
[[nodiscard]] Plan plan_of(const scene::Database& database, int quality = 9);

}  // namespace isl::render
