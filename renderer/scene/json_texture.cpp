#include "renderer/scene/json_texture.h"

#include "renderer/scene/json_pattern.h"
#include "renderer/scene/json_values.h"

namespace isl::scene {
namespace {

/// Adds the member if it differs from its default.
template <class Record, class Value>
void add(Json& json, const char* key, const Record& record, Value Record::*value) {
  static const Record kDefault{};
  if (record.*value == kDefault.*value) return;
  if constexpr (std::is_same_v<Value, Colour>) {
    json[key] = colour(record.*value);
  } else {
    json[key] = record.*value;
  }
}

template <class Id>
void add_id(Json& json, const char* key, Id id) {
  if (index(id) != kNone) json[key] = index(id);
}

void add_reflection(Json& json, const Finish& f) {
  const Reflection& r = f.reflection;
  Json reflection;
  add(reflection, "minimum", r, &Reflection::minimum);
  add(reflection, "maximum", r, &Reflection::maximum);
  add(reflection, "falloff", r, &Reflection::falloff);
  add(reflection, "exponent", r, &Reflection::exponent);
  add(reflection, "metallic", r, &Reflection::metallic);
  add(reflection, "fresnel", f, &Finish::fresnel);
  if (!reflection.is_null()) json["reflection"] = std::move(reflection);
}

void add_finish(Json& json, const Finish& f) {
  json["ambient"] = colour(f.ambient);
  add(json, "emission", f, &Finish::emission);
  json["diffuse"] = f.diffuse;
  add(json, "diffuse_albedo", f, &Finish::diffuse_albedo);
  add(json, "diffuse_back", f, &Finish::diffuse_back);
  json["brilliance"] = f.brilliance;
  json["phong"] = f.phong;
  add(json, "phong_albedo", f, &Finish::phong_albedo);
  json["phong_size"] = f.phong_size;
  json["specular"] = f.specular;
  add(json, "specular_albedo", f, &Finish::specular_albedo);
  json["roughness"] = f.roughness;
  add(json, "metallic", f, &Finish::metallic);
  add_reflection(json, f);
  add(json, "irid", f, &Finish::irid);
  add(json, "irid_thickness", f, &Finish::irid_thickness);
  add(json, "irid_turbulence", f, &Finish::irid_turbulence);
  add(json, "crand", f, &Finish::crand);
  add(json, "conserve_energy", f, &Finish::conserve_energy);
  add(json, "use_alpha", f, &Finish::use_alpha);
}

}  // namespace

Json pigment_reference(const Pigment& pigment) {
  if (pigment.is_plain()) return colour(pigment.colour);
  return {{"pigment", index(pigment.pattern)}};
}

Json texture_json(const Texture& t, const Finish& finish) {
  Json json;
  if (t.pattern != kNoTexturePattern) {
    json["texture_pattern"] = index(t.pattern);
    return json;
  }
  if (t.pigment.is_plain()) {
    json["colour"] = colour(t.pigment.colour);
  } else {
    json["pigment"] = index(t.pigment.pattern);
  }
  add_id(json, "normal", t.normal);
  add_finish(json, finish);
  if (t.uv_mapping != 0) json["uv_mapping"] = true;
  add_id(json, "below", t.below);
  return json;
}

Json pigment_json(const PatternedPigment& p) {
  Json json = pattern_json(p.pattern);
  if (p.pattern.kind == PatternKind::plain) json["colour"] = colour(p.colour);
  add_id(json, "map", p.map);
  if (p.quick_colour) json["quick_colour"] = colour(*p.quick_colour);
  return json;
}

Json pigment_map_json(const PigmentMap& map) {
  Json json = Json::array();
  for (const PigmentEntry& entry : map) json.push_back({entry.value, pigment_reference(entry.pigment)});
  return json;
}

Json normal_json(const Normal& n) {
  Json json = pattern_json(n.pattern);
  json["bump_size"] = n.bump_size;
  add(json, "accuracy", n, &Normal::accuracy);
  add(json, "no_bump_scale", n, &Normal::no_bump_scale);
  add_id(json, "slope_map", n.slope_map);
  add_id(json, "map", n.map);
  return json;
}

Json normal_map_json(const NormalMap& map) {
  Json json = Json::array();
  for (const NormalEntry& entry : map) {
    json.push_back({entry.value, entry.normal == kNoNormal ? Json() : Json(index(entry.normal))});
  }
  return json;
}

Json slope_map_json(const SlopeMap& map) {
  Json json = Json::array();
  for (const SlopeEntry& entry : map) json.push_back({entry.value, entry.height, entry.slope});
  return json;
}

Json texture_pattern_json(const TexturePattern& t) {
  Json json = pattern_json(t.pattern);
  add_id(json, "map", t.map);
  return json;
}

Json texture_map_json(const TextureMap& map) {
  Json json = Json::array();
  for (const TextureEntry& entry : map) json.push_back({entry.value, index(entry.texture)});
  return json;
}

Json interior_json(const Interior& i) {
  Json json = {{"ior", i.ior}};
  add(json, "caustics", i, &Interior::caustics);
  add(json, "dispersion", i, &Interior::dispersion);
  add(json, "dispersion_samples", i, &Interior::dispersion_samples);
  add(json, "fade_distance", i, &Interior::fade_distance);
  add(json, "fade_power", i, &Interior::fade_power);
  add(json, "fade_colour", i, &Interior::fade_colour);
  return json;
}

}  // namespace isl::scene
