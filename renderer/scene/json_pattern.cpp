#include "renderer/scene/json_pattern.h"

#include "renderer/scene/json_values.h"

namespace isl::scene {
namespace {

/// In the order of PatternKind.
constexpr std::string_view kPatternKinds[] = {
    "plain",
#define ISL_PATTERN(name, frequency) #name,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

constexpr std::string_view kWaves[] = {"ramp", "triangle", "sine", "scallop", "cubic", "poly", "none"};
constexpr std::string_view kShapes[] = {"cylindrical", "spherical", "toroidal", "planar", "cubic"};
constexpr std::string_view kImageTypes[] = {"unnamed", "bmp", "exr", "gif", "hdr", "iff",  "jpeg",    "pgm",
                                            "png",     "pot", "ppm", "sys", "tga", "tiff", "function"};
constexpr std::string_view kChannels[] = {"automatic", "index", "colour", "alpha"};

struct WarpWriter {
  Json operator()(TransformId id) const { return {{"transform", index(id)}}; }
  Json operator()(const Turbulence& w) const { return turbulence_json(w); }
  Json operator()(const RepeatWarp& w) const {
    Json json = {{"repeat", std::string_view("xyz").substr(static_cast<std::size_t>(w.axis), 1)}, {"width", w.width}};
    if (w.offset != Vec3(0)) json["offset"] = vector(w.offset);
    if (w.flip != Vec3(0)) json["flip"] = vector(w.flip);
    return json;
  }
  Json operator()(const BlackHoleWarp& w) const {
    Json json = {
        {"black_hole", vector(w.centre)}, {"radius", w.radius}, {"strength", w.strength}, {"falloff", w.falloff}};
    if (w.inverse) json["inverse"] = true;
    if (w.repeats) json["repeat"] = vector(w.repeat);
    if (w.is_turbulent) json["turbulence"] = vector(w.turbulence);
    return json;
  }
  Json operator()(const MappingWarp& w) const {
    Json json = {{"warp", name(kShapes, w.shape)}};
    if (w.shape == MappingWarp::Shape::cube) return json;
    json["orientation"] = vector(w.orientation);
    if (w.shape == MappingWarp::Shape::plane) {
      json["distance"] = w.distance;
    } else {
      json["dist_exp"] = w.distance_exponent;
    }
    if (w.shape == MappingWarp::Shape::torus) json["major_radius"] = w.major_radius;
    return json;
  }
};

struct ValueWriter {
  Json operator()(const Vec3& value) const { return vector(value); }
  Json operator()(const std::vector<std::variant<double, int>>& values) const {
    Json json = Json::array();
    for (const auto& value : values) std::visit([&json](const auto number) { json.push_back(number); }, value);
    return json;
  }
  template <class Value>
  Json operator()(const Value& value) const {
    return value;
  }
};

/// Adds the operands to the pattern's JSON.
struct OperandWriter {
  Json& json;

  void operator()(std::monostate /*none*/) const {}
  void operator()(const Operands& o) const {
    for (const OperandField& field : o.fields) {
      if (field.is_dumped && !field.is_dumped(o.record)) continue;
      json[std::string(field.key)] = std::visit(ValueWriter(), field.get(o.record));
    }
  }
  void operator()(const FunctionOperands& o) const {
    if (o.function != kNoFunction) json["function"] = index(o.function);
  }
  void operator()(ImageId id) const { json["image"] = index(id); }
  void operator()(const ObjectOperands& o) const {
    if (o.object != kNone) json["object"] = o.object;
    if (o.less_threshold) json["threshold"] = true;
  }
  void operator()(const ColourOperands& o) const {
    Json& terms = json["functions"] = Json::array();
    for (const FunctionId term : o.terms) terms.push_back(term == kNoFunction ? Json() : Json(index(term)));
  }
  void operator()(const PigmentOperands& o) const { json["pigment"] = index(o.pigment); }
};

}  // namespace

Json turbulence_json(const Turbulence& t) {
  return {{"turbulence", vector(t.amount)}, {"octaves", t.octaves}, {"lambda", t.lambda}, {"omega", t.omega}};
}

Json pattern_json(const Pattern& p) {
  Json json = {{"pattern", name(kPatternKinds, p.kind)}};
  std::visit(OperandWriter{json}, p.operands);
  if (p.uv_mapping) json["uv_mapping"] = true;
  if (p.wave != Wave::ramp) json["wave"] = name(kWaves, p.wave);
  if (p.wave == Wave::poly) json["poly_wave"] = p.exponent;
  if (p.frequency != default_frequency(p.kind)) json["frequency"] = p.frequency;
  if (p.phase != 0) json["phase"] = p.phase;
  if (p.noise_generator != 0) json["noise_generator"] = p.noise_generator;
  if (p.turbulence.amount != Vec3(0)) json.update(turbulence_json(p.turbulence));
  if (p.warps.empty()) return json;
  Json& warps = json["warps"] = Json::array();
  for (const Warp& warp : p.warps) warps.push_back(std::visit(WarpWriter(), warp));
  return json;
}

Json image_json(const Image& i) {
  Json json = {{"type", name(kImageTypes, i.type)}};
  if (i.type == ImageType::function) {
    json["size"] = Json::array({i.width, i.height});
    if (i.function != kNoFunction) json["function"] = index(i.function);
  } else {
    json["file"] = i.file;
  }
  if (i.map_type != 0) json["map_type"] = i.map_type;
  if (i.interpolate != 0) json["interpolate"] = i.interpolate;
  if (i.once) json["once"] = true;
  if (i.repeat_x != 1 || i.repeat_y != 1) json["repeat"] = Json::array({i.repeat_x, i.repeat_y});
  if (i.offset_x != 0 || i.offset_y != 0) json["offset"] = Json::array({i.offset_x, i.offset_y});
  if (i.channel != ImageChannel::automatic) json["channel"] = name(kChannels, i.channel);
  if (i.gamma) json["gamma"] = *i.gamma;
  if (i.gamma_srgb) json["gamma"] = "srgb";
  if (i.premultiplied) json["premultiplied"] = *i.premultiplied;
  const auto add_transparency = [&](const char* key, const std::optional<double>& all,
                                    const std::vector<PaletteTransparency>& entries) {
    if (all) json[std::string(key) + "_all"] = *all;
    for (const PaletteTransparency& entry : entries) json[key].push_back(Json::array({entry.index, entry.amount}));
  };
  add_transparency("filter", i.filter_all, i.filters);
  add_transparency("transmit", i.transmit_all, i.transmits);
  if (i.scales_opacity) json["scales_opacity"] = true;
  return json;
}

}  // namespace isl::scene
