#include "renderer/scene/json_view.h"

#include "renderer/scene/json_texture.h"
#include "renderer/scene/json_values.h"

namespace isl::scene {
namespace {

constexpr std::string_view kCameraKinds[] = {"perspective", "orthographic", "fisheye",   "ultra_wide_angle", "omnimax",
                                             "panoramic",   "cylinder",     "spherical", "user_defined"};
constexpr std::string_view kLightKinds[] = {"point", "spotlight", "cylinder"};

Json blur_json(const FocalBlur& blur) {
  Json json = {{"aperture", blur.aperture},
               {"focal_distance", blur.focal_distance},
               {"samples", Json::array({blur.min_samples, blur.max_samples})},
               {"confidence", blur.confidence},
               {"variance", blur.variance}};
  if (blur.bokeh) json["bokeh"] = pigment_reference(*blur.bokeh);
  return json;
}

Json area_json(const AreaLight& area) {
  Json json = {{"edge_a", vector(area.edge_a)},
               {"edge_b", vector(area.edge_b)},
               {"counts", Json::array({area.count_a, area.count_b})}};
  if (area.adaptive != AreaLight::kNotAdaptive) json["adaptive"] = area.adaptive;
  if (area.jitter) json["jitter"] = true;
  if (area.circular) json["circular"] = true;
  if (area.orient) json["orient"] = true;
  if (area.area_illumination) json["area_illumination"] = true;
  return json;
}

}  // namespace

Json camera_json(const Camera& c) {
  Json json;
  if (c.kind != CameraKind::perspective) json["kind"] = name(kCameraKinds, c.kind);
  if (c.kind == CameraKind::cylinder) json["type"] = c.cylinder_type;
  json["location"] = vector(c.location);
  json["direction"] = vector(c.direction);
  json["right"] = vector(c.right);
  json["up"] = vector(c.up);
  if (c.angle != 0) json["angle"] = c.angle;
  if (c.vertical_angle != 0) json["vertical_angle"] = c.vertical_angle;
  const auto add_functions = [&json](const char* key, const VectorFunctions& functions) {
    if (functions == kNoVectorFunctions) return;
    for (const FunctionId function : functions) json[key].push_back(index(function));
  };
  add_functions("location_of", c.location_of);
  add_functions("direction_of", c.direction_of);
  if (c.blur) json["blur"] = blur_json(*c.blur);
  if (c.normal != kNoNormal) json["normal"] = index(c.normal);
  return json;
}

Json light_json(const Light& l) {
  Json json;
  if (l.kind != LightKind::point) json["kind"] = name(kLightKinds, l.kind);
  json["location"] = vector(l.location);
  json["colour"] = colour(l.colour);
  if (l.shadowless) json["shadowless"] = true;
  if (l.parallel) json["parallel"] = true;
  if (l.kind != LightKind::point || l.parallel) json["point_at"] = vector(l.point_at);
  if (l.kind != LightKind::point) {
    json["radius"] = l.radius;
    json["falloff"] = l.falloff;
    json["tightness"] = l.tightness;
  }
  if (l.fade_distance != 0) json["fade_distance"] = l.fade_distance;
  if (l.fade_power != 0) json["fade_power"] = l.fade_power;
  if (l.fades_from_point && l.fade_power != 0) json["fades_from_point"] = true;
  if (l.area) json["area"] = area_json(*l.area);
  if (!l.media_interaction) json["media_interaction"] = false;
  if (l.media_attenuation) json["media_attenuation"] = true;
  if (l.projected_through != kNoGroup) {
    json["projected_through"] = index(l.projected_through);
    if (l.world_from_projected != Transform()) json["transform"] = transform(l.world_from_projected);
  }
  return json;
}

}  // namespace isl::scene
