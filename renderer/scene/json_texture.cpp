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
#define ISL_REFLECTION_NUMBER(word, otherwise, form) add(reflection, #word, r, &Reflection::word);
#include "renderer/scene/finish.def"
  add(reflection, "fresnel", f, &Finish::fresnel_reflection);
  if (!reflection.is_null()) json["reflection"] = std::move(reflection);
}

/// Adds the member always, or if it differs from its default.
template <class Value>
void add_item(Json& json, const char* key, const Finish& finish, Value Finish::*value, FinishDump when) {
  if (when == FinishDump::changed) return add(json, key, finish, value);
  if constexpr (std::is_same_v<Value, Colour>) {
    json[key] = colour(finish.*value);
  } else {
    json[key] = finish.*value;
  }
}

void add_finish(Json& json, const Finish& f) {
#define ISL_FINISH_COLOUR(word, grey, dump) add_item(json, #word, f, &Finish::word, FinishDump::dump);
#define ISL_FINISH_NUMBER(word, otherwise, form, dump) add_item(json, #word, f, &Finish::word, FinishDump::dump);
#define ISL_FINISH_FLAG(word, form, dump) add_item(json, #word, f, &Finish::word, FinishDump::dump);
#include "renderer/scene/finish.def"
  add(json, "irid", f, &Finish::irid);
  add_reflection(json, f);
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
