#include "renderer/scene/dump_json.h"

#include "renderer/scene/json_function.h"
#include "renderer/scene/json_pattern.h"
#include "renderer/scene/json_solid.h"
#include "renderer/scene/json_statement.h"
#include "renderer/scene/json_texture.h"
#include "renderer/scene/json_values.h"
#include "renderer/scene/json_view.h"

#include <string_view>

namespace isl::scene {
namespace {

constexpr std::string_view kRadiusMeanings[] = {"surface", "support"};
constexpr std::string_view kObjectKinds[] = {"solid", "blob", "group"};
constexpr std::string_view kOperations[] = {"union", "merge", "intersection", "difference"};

Json kernel(const Kernel& k) {
  Json json = {{"shape", name(kKernelWords, k.shape)}, {"radius", name(kRadiusMeanings, k.meaning)}};
  if (k.meaning == RadiusMeaning::surface) json["hardness"] = k.hardness;
  if (k.mode == FieldMode::convolution) json["mode"] = "convolution";
  if (k.mode == FieldMode::sheet) json["mode"] = "sheet";
  return json;
}

class Writer {
 public:
  Writer(const Database& database, const DescribeOrigin& describe_origin)
      : database_(database), describe_origin_(describe_origin) {}

  [[nodiscard]] Json write() const {
    Json json = {{"settings", settings()}};
    if (database_.camera) json["camera"] = camera_json(*database_.camera);
    add(json, "kernels", database_.kernels, kernel);
    add(json, "textures", database_.textures,
        [this](const Texture& t) { return texture_json(t, database_.finish(t.finish)); });
    add(json, "texture_patterns", database_.texture_patterns, texture_pattern_json);
    add(json, "texture_maps", database_.texture_maps, texture_map_json);
    add(json, "pigments", database_.pigments, pigment_json);
    add(json, "pigment_maps", database_.pigment_maps, pigment_map_json);
    add(json, "normals", database_.normals, normal_json);
    add(json, "normal_maps", database_.normal_maps, normal_map_json);
    add(json, "slope_maps", database_.slope_maps, slope_map_json);
    add(json, "images", database_.images, image_json);
    if (!database_.functions.empty()) json["functions"] = functions_json(database_.functions);
    add(json, "interiors", database_.interiors, interior_json);
    add(json, "transforms", database_.transforms, transform);
    add(json, "blobs", database_.blobs, [this](const Blob& b) { return blob(b); });
    add(json, "solids", database_.solids, [this](const Solid& s) { return solid_json(database_, s); });
    add(json, "groups", database_.groups, [this](const Group& g) { return group(g); });
    if (!database_.pattern_objects.empty()) json["pattern_objects"] = objects(database_.pattern_objects);
    if (!database_.objects.empty()) json["objects"] = objects(database_.objects);
    add(json, "lights", database_.lights, [this](const Light& l) { return light(l); });
    add_statements(json);
    return json;
  }

 private:
  void add_statements(Json& json) const {
    for (const Statement& statement : database_.statements) {
      Json record = statement_json(statement);
      add_origin(record, statement.origin);
      const StatementKind& kind = *statement.kind;
      if (kind.list.empty()) {
        json[std::string(kind.word)] = std::move(record);
      } else {
        json[std::string(kind.list)].push_back(std::move(record));
      }
    }
  }

  template <class Record, class Convert>
  static void add(Json& json, std::string_view key, const std::vector<Record>& records, Convert convert) {
    if (records.empty()) return;
    Json& list = json[std::string(key)] = Json::array();
    for (const Record& record : records) list.push_back(convert(record));
  }

  void add_origin(Json& json, OriginId id) const {
    if (!describe_origin_ || id.value == 0) return;
    Json origin = describe_origin_(id);
    if (!origin.is_null()) json["origin"] = std::move(origin);
  }

  [[nodiscard]] Json settings() const {
    const Settings& s = database_.settings;
    Json json = {{"language_version", s.language_version}};
    if (s.assumed_gamma) json["assumed_gamma"] = *s.assumed_gamma;
    if (s.assumed_gamma_srgb) json["assumed_gamma"] = "srgb";
    json["ambient_light"] = colour(s.ambient_light);
    json["background"] = colour(s.background);
    json["max_trace_level"] = s.max_trace_level;
    json["adc_bailout"] = s.adc_bailout;
    const Settings unsaid;
    if (s.irid_wavelength != unsaid.irid_wavelength) json["irid_wavelength"] = colour(s.irid_wavelength);
    if (s.number_of_waves != unsaid.number_of_waves) json["number_of_waves"] = s.number_of_waves;
    if (s.noise_generator != unsaid.noise_generator) json["noise_generator"] = s.noise_generator;
    if (s.mm_per_unit != unsaid.mm_per_unit) json["mm_per_unit"] = s.mm_per_unit;
    if (!s.solver.empty()) json["solver"] = s.solver;
    if (!s.tolerance.empty()) json["tolerance"] = s.tolerance;
    return json;
  }

  [[nodiscard]] Json component(const Blob& b, const Component& c, OriginId origin) const {
    Json json = {{"skeleton", name(kSkeletonWords, c.skeleton)}, {"a", vector(c.a)}};
    if (has_b(c.skeleton)) json["b"] = vector(c.b);
    if (has(c.skeleton, kCorner)) json["c"] = vector(b.corners[c.corner]);
    json["radius"] = c.radius_a;
    if (has(c.skeleton, kRadiusB)) json["radius_b"] = c.radius_b;
    json["strength"] = c.strength;
    json["kernel"] = index(c.kernel);
    if (c.texture != kNoTexture) json["texture"] = index(c.texture);
    if (c.transform != kIdentity) json["transform"] = index(c.transform);
    add_origin(json, origin);
    return json;
  }

  [[nodiscard]] Json blob(const Blob& b) const {
    Json components = Json::array();
    for (std::size_t i = 0; i < b.components.size(); ++i) {
      components.push_back(component(b, b.components[i], i < b.origins.size() ? b.origins[i] : OriginId{}));
      if (!b.branches.empty()) components.back()["branch"] = b.branch_of[i];
      if (!b.turns.empty() && !b.turns[i].is_none()) {
        for (const auto& row : b.turns[i].matrix.x)
          components.back()["turn"].push_back(vector({row[0], row[1], row[2]}));
      }
    }
    Json json = {{"threshold", b.threshold}, {"components", std::move(components)}};
    if (b.is_unblended) json["skeleton"] = true;
    for (std::size_t i = 1; i < b.branches.size(); ++i) {
      json["branches"].push_back({{"parent", b.branches[i].parent}, {"maximum", b.branches[i].maximum}});
    }
    return json;
  }

  [[nodiscard]] Json group(const Group& g) const {
    Json json = Json::object();
    if (g.operation != Operation::unite) json["operation"] = name(kOperations, g.operation);
    if (g.cutaway_textures) json["cutaway_textures"] = true;
    if (g.is_light_group) json["global_lights"] = g.global_lights;
    json["children"] = objects(g.children);
    add(json, "lights", g.lights, [this](const Light& l) { return light(l); });
    return json;
  }

  static void add_flags(Json& json, const Object& object) {
    const std::pair<std::string_view, bool> flags[] = {{"no_shadow", object.no_shadow},
                                                       {"no_image", object.no_image},
                                                       {"no_reflection", object.no_reflection},
                                                       {"no_radiosity", object.no_radiosity},
                                                       {"double_illuminate", object.double_illuminate},
                                                       {"hollow", object.hollow},
                                                       {"inverse", object.inverse}};
    for (const auto& [flag, is_set] : flags) {
      if (is_set) json[std::string(flag)] = true;
    }
  }

  [[nodiscard]] Json objects(const std::vector<Object>& list) const {
    Json json = Json::array();
    for (const Object& object : list) {
      Json entry = {{name(kObjectKinds, object.kind), object.shape}};
      if (object.texture != kNoTexture) entry["texture"] = index(object.texture);
      if (object.interior_texture != kNoTexture) entry["interior_texture"] = index(object.interior_texture);
      if (object.interior != kNoInterior) entry["interior"] = index(object.interior);
      if (object.clip != kNoGroup) entry["clip"] = index(object.clip);
      if (object.bound != kNoGroup) entry["bound"] = index(object.bound);
      add_flags(entry, object);
      if (object.parent_from_object != Transform()) entry["transform"] = transform(object.parent_from_object);
      add_origin(entry, object.origin);
      json.push_back(std::move(entry));
    }
    return json;
  }

  [[nodiscard]] Json light(const Light& l) const {
    Json json = light_json(l);
    add_origin(json, l.origin);
    return json;
  }

  const Database& database_;
  const DescribeOrigin& describe_origin_;
};

/// Recursion is safe: the nesting is a few levels deep, since a group refers to its children's shapes by number.
void print(const Json& json, std::size_t indent, std::string& text) {
  constexpr std::size_t kLineWidth = 160;
  const std::string flat = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (indent > 0 && (!json.is_structured() || flat.size() + indent <= kLineWidth)) {
    text += flat;
    return;
  }
  const std::string padding(indent + 2, ' ');
  text += json.is_array() ? '[' : '{';
  bool is_first = true;
  for (const auto& [key, value] : json.items()) {
    text += is_first ? "\n" : ",\n";
    is_first = false;
    text += padding;
    if (json.is_object()) text += Json(key).dump() + ": ";
    print(value, indent + 2, text);
  }
  text += '\n' + std::string(indent, ' ') + (json.is_array() ? ']' : '}');
}

}  // namespace

Json to_json(const Database& database, const DescribeOrigin& describe_origin) {
  return Writer(database, describe_origin).write();
}

std::string dump_json(const Database& database, const DescribeOrigin& describe_origin) {
  std::string text;
  print(to_json(database, describe_origin), 0, text);
  return text + '\n';
}

}  // namespace isl::scene
