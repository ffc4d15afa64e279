#include "renderer/scene/json_atmosphere.h"

#include "renderer/scene/json_pattern.h"
#include "renderer/scene/json_texture.h"
#include "renderer/scene/json_values.h"

namespace isl::scene {

Json sky_sphere_json(const SkySphere& sky) {
  Json json;
  for (const Pigment& pigment : sky.pigments) json["pigments"].push_back(pigment_reference(pigment));
  if (sky.emission != Colour{1, 1, 1}) json["emission"] = colour(sky.emission);
  if (sky.world_from_sky != kIdentity) json["transform"] = index(sky.world_from_sky);
  return json;
}

Json fog_json(const Fog& fog) {
  const bool is_ground = fog.kind == Fog::Kind::ground;
  Json json = {{"kind", is_ground ? "ground" : "constant"}, {"colour", colour(fog.colour)}, {"distance", fog.distance}};
  if (fog.turbulence.amount != Vec3(0)) {
    json.update(turbulence_json(fog.turbulence));
    json["turb_depth"] = fog.turbulence_depth;
  }
  if (!is_ground) return json;
  json["offset"] = fog.offset;
  json["altitude"] = fog.altitude;
  json["up"] = vector(fog.up);
  return json;
}

Json rainbow_json(const Rainbow& r) {
  Json json = {{"direction", vector(r.direction)},
               {"up", vector(r.up)},
               {"angle", r.angle},
               {"width", r.width},
               {"distance", r.distance},
               {"jitter", r.jitter},
               {"arc_angle", r.arc_angle},
               {"falloff_angle", r.falloff_angle}};
  if (r.colours != kNoPigmentMap) json["colours"] = index(r.colours);
  return json;
}

}  // namespace isl::scene
