// What surfaces look like.
#pragma once

#include "renderer/scene/colour.h"

namespace isl::scene {

struct Pigment {
  Colour colour{};  ///< POV-Ray's default pigment is black
};

/// POV-Ray 3.7's defaults.
struct Finish {
  Colour ambient{0.1, 0.1, 0.1};
  double diffuse = 0.6;
  double brilliance = 1;
  double phong = 0;
  double phong_size = 40;
  double specular = 0;
  double roughness = 0.05;
};

struct Texture {
  Pigment pigment;
  Finish finish;
};

}  // namespace isl::scene
