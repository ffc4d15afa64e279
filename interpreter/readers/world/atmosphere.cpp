#include "interpreter/readers/world/atmosphere.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/readers/patterns/warp.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::interpreter {
namespace {

using scene::Fog;
using scene::Rainbow;
using scene::SkySphere;
namespace word = grammar::word;

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The declared value that the block begins with, if it is of this kind; null otherwise.
template <class Declared>
Ref<Declared> read_declared_name(ElementStream& stream, ValueKind kind, std::string_view what) {
  const Element first = stream.peek();
  if (!first.is(ElementKind::value) || first.node->kind != grammar::NodeKind::name) return {};
  const Slot* const slot = without_wrapper(stream.context().scopes.find(first.word));
  if (slot->value.is_numeric()) return {};
  const Value value = stream.take_value();
  if (value.kind() != kind) {
    stream.context().fail(first.span, fmt::format("expected {} or its items, found {}", what, describe(value)));
  }
  return Ref<Declared>(&value.as<Declared>());
}

/// POV-Ray's manual says "by default a sufficiently large value": farther than anything it draws.
constexpr double kFarRainbow = 1e7;

// ---- Sky sphere -----------------------------------------------------------------------------------------------------

void move(Context& context, SkySphere& sky, const scene::Transform& transform) {
  auto& transforms = context.database.transforms;
  const bool has_one = sky.world_from_sky != scene::kIdentity;
  const scene::Transform total = has_one ? scene::then(transforms[index(sky.world_from_sky)], transform) : transform;
  sky.world_from_sky = add_record<scene::TransformId>(context, transforms, total);
}

bool read_sky_item(ElementStream& stream, SkySphere& sky) {
  Context& context = stream.context();
  if (const std::optional<scene::Transform> transform = read_transform(stream)) {
    move(context, sky, *transform);
    return true;
  }
  const Element next = stream.peek();
  if (next.is_block(word::kw_pigment)) {
    stream.drop();
    sky.pigments.push_back(read_pigment(context, next, context.default_texture.pigment));
    return true;
  }
  if (!next.is_word(word::kw_emission)) return false;
  stream.drop();
  sky.emission = read_colour(stream);
  return true;
}

// ---- Fog ------------------------------------------------------------------------------------------------------------

struct FogRow {
  grammar::Symbol word;
  double Fog::*value;
};

constexpr FogRow kFogNumbers[] = {{word::kw_distance, &Fog::distance},
                                  {word::kw_turb_depth, &Fog::turbulence_depth},
                                  {word::kw_fog_offset, &Fog::offset},
                                  {word::kw_fog_alt, &Fog::altitude}};

constexpr ItemWord<scene::FogItem> kFogPlaces[] = {{word::kw_fog_type, scene::FogItem::type},
                                                   {word::kw_turbulence, scene::FogItem::turbulence}};

void read_fog_type(ElementStream& stream, Fog& fog) {
  const SourceSpan span = stream.peek().span;
  const double type = read_number(stream, "a number after `fog_type`");
  if (type != 1 && type != 2) stream.context().fail(span, fmt::format("`fog_type` must be 1 or 2, found {:g}", type));
  fog.kind = type == 1 ? Fog::Kind::constant : Fog::Kind::ground;
}

/// Reads a colour, or a lone number, which is POV-Ray 1's distance.
void read_fog_value(ElementStream& stream, Fog& fog) {
  const Element next = stream.peek();
  const Value value = stream.take_value();
  if (value.is_number()) {
    stream.context().warn(next.span, "found a number without a word; write `distance` before it");
    fog.distance = value.number();
  } else if (value.is_numeric() && next.node->kind != grammar::NodeKind::vector) {
    fog.colour = to_colour(read_colour_after(stream, value));
  } else {
    stream.context().fail(next.span, fmt::format("expected an item of a fog, found {}", describe(value)),
                          value.is_numeric() ? "write `rgb` before it" : "");
  }
}

bool read_fog_item(ElementStream& stream, Fog& fog) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is(ElementKind::value)) {
    read_fog_value(stream, fog);
    return true;
  }
  // Transforms change only the direction of the height; a scale changes no length.
  if (const std::optional<scene::Transform> transform = read_transform(stream)) {
    fog.up = transform->vector(fog.up).normalized();
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  if (is_colour_word(next.word)) {
    fog.colour = read_colour(stream);
    return true;
  }
  if (read_turbulence_item(stream, fog.turbulence)) return true;
  if (const auto* const row = std::ranges::find(kFogNumbers, next.word, &FogRow::word); row != std::end(kFogNumbers)) {
    stream.drop();
    fog.*row->value = read_number(stream, fmt::format("a number after `{}`", context.text(next.word)));
    return true;
  }
  if (next.word == word::kw_fog_type) {
    stream.drop();
    read_fog_type(stream, fog);
    return true;
  }
  if (next.word != word::kw_up) return false;
  stream.drop();
  fog.up = read_vector(stream, "a vector after `up`").normalized();
  return true;
}

// ---- Rainbow --------------------------------------------------------------------------------------------------------

struct RainbowRow {
  grammar::Symbol word;
  double Rainbow::*value;
  bool is_angle;
};

constexpr RainbowRow kRainbowNumbers[] = {
    {word::kw_angle, &Rainbow::angle, true},         {word::kw_width, &Rainbow::width, true},
    {word::kw_distance, &Rainbow::distance, false},  {word::kw_jitter, &Rainbow::jitter, false},
    {word::kw_arc_angle, &Rainbow::arc_angle, true}, {word::kw_falloff_angle, &Rainbow::falloff_angle, true},
};

bool read_rainbow_item(ElementStream& stream, Rainbow& rainbow) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is_block(word::kw_color_map) || next.is_block(word::kw_colour_map)) {
    stream.drop();
    rainbow.colours = read_colour_map(context, next);
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  const auto* const row = std::ranges::find(kRainbowNumbers, next.word, &RainbowRow::word);
  if (row != std::end(kRainbowNumbers)) {
    stream.drop();
    const std::string what = fmt::format("a number after `{}`", context.text(next.word));
    const bool is_arc = row->value == &Rainbow::arc_angle || row->value == &Rainbow::falloff_angle;
    const double value = is_arc ? read_number_in(stream, fmt::format("`{}`", context.text(next.word)), 0, 360)
                                : read_number(stream, what);
    rainbow.*row->value = row->is_angle ? radians(value) : value;
    return true;
  }
  if (next.word != word::kw_direction && next.word != word::kw_up) return false;
  stream.drop();
  scene::Vec3& vector = next.word == word::kw_up ? rainbow.up : rainbow.direction;
  vector = read_vector(stream, fmt::format("a vector after `{}`", context.text(next.word)));
  return true;
}

/// Checks POV-Ray's conditions and makes `up` perpendicular to the direction.
void check_rainbow(ElementStream& stream, Rainbow& rainbow) {
  Context& context = stream.context();
  if (rainbow.direction.length() == 0) context.fail(stream.span(), "a `rainbow` needs a `direction` that is not zero");
  rainbow.direction.normalize();
  const scene::Vec3 up = rainbow.up - rainbow.direction * rainbow.up.dot(rainbow.direction);
  if (up.length() <= 1e-7 * rainbow.up.length()) {  // parallel within rounding: a cosine of one
    context.fail(stream.span(), "`up` and `direction` of a `rainbow` are parallel");
  }
  rainbow.up = up.normalized();
  if (rainbow.falloff_angle > rainbow.arc_angle) {
    context.fail(stream.span(), "`falloff_angle` must be at most `arc_angle`");
  }
}

}  // namespace

SkySphere read_sky_sphere(Context& context, const Element& block) {
  ElementStream stream(context, block);
  SkySphere sky;
  if (const auto named = read_declared_name<SkySphereValue>(stream, ValueKind::sky_sphere, "a sky_sphere")) {
    sky = named->sky_sphere;
  }
  sky.origin = context.origin(block.span);
  while (!stream.peek().is(ElementKind::end)) {
    if (read_sky_item(stream, sky)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_pigment, word::kw_emission, word::kw_rotate};
    refuse(stream, kKnown);
  }
  if (sky.pigments.empty()) context.fail(block.word_span, "a `sky_sphere` needs a `pigment`");
  return sky;
}

Fog read_fog(Context& context, const Element& block) {
  ElementStream stream(context, block);
  Fog fog;
  if (const auto named = read_declared_name<FogValue>(stream, ValueKind::fog, "a fog")) fog = named->fog;
  fog.origin = context.origin(block.span);
  while (!stream.peek().is(ElementKind::end)) {
    note_place(context, stream.peek(), kFogPlaces, fog.said_at);
    if (read_fog_item(stream, fog)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_distance, word::kw_color,      word::kw_fog_type,
                                                 word::kw_fog_alt,  word::kw_fog_offset, word::kw_turbulence};
    refuse(stream, kKnown);
  }
  return fog;
}

Rainbow read_rainbow(Context& context, const Element& block) {
  ElementStream stream(context, block);
  Rainbow rainbow;
  rainbow.arc_angle = rainbow.falloff_angle = radians(180);
  rainbow.distance = kFarRainbow;
  if (const auto named = read_declared_name<RainbowValue>(stream, ValueKind::rainbow, "a rainbow")) {
    rainbow = named->rainbow;
  }
  rainbow.origin = context.origin(block.span);
  while (!stream.peek().is(ElementKind::end)) {
    if (read_rainbow_item(stream, rainbow)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_direction, word::kw_angle,     word::kw_width,
                                                 word::kw_distance,  word::kw_color_map, word::kw_arc_angle};
    refuse(stream, kKnown);
  }
  check_rainbow(stream, rainbow);
  return rainbow;
}

void place_sky_sphere(Context& context, const Element& block) {
  SkySphere sky = read_sky_sphere(context, block);
  if (context.database.sky_sphere) context.warn(block.word_span, "this sky_sphere replaces an earlier one");
  context.database.sky_sphere = std::move(sky);
}

void place_fog(Context& context, const Element& block) {
  const Fog fog = read_fog(context, block);
  context.count_primitive(block.span, sizeof(Fog));
  context.database.fogs.push_back(fog);
}

void place_rainbow(Context& context, const Element& block) {
  const Rainbow rainbow = read_rainbow(context, block);
  context.count_primitive(block.span, sizeof(Rainbow));
  context.database.rainbows.push_back(rainbow);
}

}  // namespace isl::interpreter
