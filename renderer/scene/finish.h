// Finishes: how a surface reflects and emits light.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/said_at.h"

#include <cstdint>

namespace isl::scene {

/// Reflection of other things: from `minimum` seen head-on to `maximum` at grazing angles.
struct Reflection {
  Colour minimum{}, maximum{};
  double falloff = 1;
  double exponent = 1;  ///< exponent of the reflected brightness
  double metallic = 0;
};

/// Items whose places are kept.
enum class FinishItem : std::uint8_t {
  ambient,
  emission,
  diffuse,
  phong,
  specular,
  metallic,
  reflection,
  fresnel,
  exponent,
  irid,
  crand,
  conserve_energy,
  use_alpha,
  count
};

/// POV-Ray 3.7's defaults. Comparable byte by byte once its places are taken away (without_places).
struct Finish {
  Colour ambient{0.1, 0.1, 0.1};
  Colour emission{};
  double diffuse = 0.6;
  double diffuse_back = 0;  ///< `diffuse` of light from behind
  double brilliance = 1;
  double phong = 0;
  double phong_size = 40;
  double specular = 0;
  double roughness = 0.05;
  double metallic = 0;  ///< share of the pigment's colour in highlights
  Reflection reflection{};
  double irid = 0;
  double irid_thickness = 0;
  double irid_turbulence = 0;
  double crand = 0;
  double old_ior = 0;  ///< `ior` of POV-Ray 3.0, for the interior of an object without one; 0: not set
  double old_caustics = 0;
  // The flags fill eight bytes, so that there is no padding.
  bool diffuse_albedo = false;  ///< `diffuse` is the total reflected light, not the peak
  bool phong_albedo = false;
  bool specular_albedo = false;
  bool fresnel = false;  ///< reflection by Fresnel's formula with the interior's ior
  bool conserve_energy = false;
  bool use_alpha = false;  ///< highlights and reflections are as transparent as the pigment
  bool unused[2] = {};
  SaidAt<FinishItem> said_at{};
  OriginId named_at{};  ///< place of the identifier, if the finish is a declared one
};

static_assert(sizeof(Finish) == 2 * sizeof(Colour) + sizeof(Reflection) + 14 * sizeof(double) + 8 * sizeof(bool) +
                                    sizeof(SaidAt<FinishItem>) + sizeof(OriginId),
              "no padding");

[[nodiscard]] inline Finish without_places(Finish finish) {
  finish.said_at = {};
  finish.named_at = {};
  return finish;
}

/// True if the finish reflects at any angle.
[[nodiscard]] inline bool reflects(const Finish& finish) {
  const auto shines = [](const Colour& colour) { return colour.red != 0 || colour.green != 0 || colour.blue != 0; };
  return shines(finish.reflection.minimum) || shines(finish.reflection.maximum);
}

}  // namespace isl::scene
