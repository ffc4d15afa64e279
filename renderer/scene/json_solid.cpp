#include "renderer/scene/json_solid.h"

#include "renderer/scene/json_values.h"

#include <span>

namespace isl::scene {
namespace {

Json value_json(int value) { return value; }
Json value_json(const std::vector<double>& values) { return values; }
Json value_json(std::string_view text) { return text; }
Json value_json(const std::vector<std::uint8_t>& values) { return values; }
Json value_json(const std::vector<std::uint32_t>& values) { return values; }
Json value_json(const std::vector<PlanePoint>& list) {
  Json json = Json::array();
  for (const PlanePoint& p : list) json.push_back({p.u, p.v});
  return json;
}
Json value_json(std::span<const Vec3> list) {
  Json json = Json::array();
  for (const Vec3& v : list) json.push_back(vector(v));
  return json;
}

}  // namespace

Json solid_json(const Database& database, const Solid& solid) {
  const SolidTraits& traits = traits_of(solid.kind);
  Json json = {{"kind", traits.word}};
  if (!traits.a.empty()) json[std::string(traits.a)] = vector(solid.a);
  if (!traits.b.empty()) json[std::string(traits.b)] = vector(solid.b);
  if (!traits.radius_a.empty()) json[std::string(traits.radius_a)] = solid.radius_a;
  if (!traits.radius_b.empty()) json[std::string(traits.radius_b)] = solid.radius_b;
  if (solid.open) json["open"] = true;
  const auto say = [&](const char* name, const auto& value) { json[name] = value_json(value); };
  switch (traits.detail) {
    case SolidDetail::none: break;
#define ISL_SOLID_DETAIL(word, Type, column)                 \
  case SolidDetail::word:                                    \
    database.column[solid.detail].describe(solid.kind, say); \
    break;
#include "renderer/scene/solids.def"
  }
  return json;
}

}  // namespace isl::scene
