// What a scene holds and the renderer cannot draw yet. The database records everything that the language says; this
// list is what keeps a picture from differing silently. A part of the renderer that learns to draw something takes its
// row out of unrendered_features.cpp.
#pragma once

#include "renderer/scene/database.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isl::scene {

struct Unrendered {
  std::string what;         ///< as the language calls it: "`torus`"
  OriginId origin;          ///< of the first
  std::uint64_t count = 0;  ///< how many things of the scene say it; of what a shared group holds, each once
};

/// Each kind once, in the order in which a walk over the camera, the lights and the objects meets them.
[[nodiscard]] std::vector<Unrendered> unrendered(const Database& database);

/// Leaves out what unrendered() names: it goes back to what it is where the scene says nothing.
void leave_out_unrendered(Database& database);

}  // namespace isl::scene
