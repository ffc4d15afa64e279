#include "renderer/scene/unrendered_textures.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <variant>

namespace isl::scene {
namespace {

bool is_transparent(const Colour& colour) { return colour.filter != 0 || colour.transmit != 0; }

bool is_patterned(const Database& database, const Pigment& pigment) {
  return !pigment.is_plain() && database.pigments[index(pigment.pattern)].pattern.kind != PatternKind::plain;
}

/// What needs more than a point, or a file.
constexpr PatternKind kNotDrawn[] = {
    PatternKind::aoi,           PatternKind::bump_map, PatternKind::density_file, PatternKind::facets, PatternKind::image_map,
    PatternKind::image_pattern, PatternKind::material_map, PatternKind::pavement, PatternKind::slope, PatternKind::tiling};

/// Whether any pigment that this one is made of, itself included, is as `is_such` says; each is looked at once.
class PigmentWalk {
 public:
  using IsSuch = bool (*)(const Pigment&, const PatternedPigment*);
  PigmentWalk(const Database& database, IsSuch is_such) : database_(database), is_such_(is_such) {}

  bool finds(const Pigment& pigment) {
    if (pigment.is_plain()) return is_such_(pigment, nullptr);
    if (!seen_.insert(index(pigment.pattern)).second) return false;
    const PatternedPigment& record = database_.pigments[index(pigment.pattern)];
    if (is_such_(pigment, &record)) return true;
    if (const auto* const inner = std::get_if<PigmentOperands>(&record.pattern.operands)) {
      if (finds({.pattern = inner->pigment})) return true;
    }
    if (record.map == kNoPigmentMap) return false;
    const auto finds_in = [this](const PigmentEntry& entry) { return finds(entry.pigment); };
    return std::ranges::any_of(database_.pigment_maps[index(record.map)], finds_in);
  }

 private:
  const Database& database_;
  IsSuch is_such_;
  std::unordered_set<std::uint32_t> seen_;
};

bool is_undrawable(const Pattern& pattern) { return std::ranges::find(kNotDrawn, pattern.kind) != std::end(kNotDrawn); }

bool is_undrawable(const Pigment&, const PatternedPigment* record) { return record && is_undrawable(record->pattern); }

bool lets_light_through(const Pigment& pigment, const PatternedPigment* record) {
  if (!record) return is_transparent(pigment.colour);
  return record->pattern.kind == PatternKind::plain && is_transparent(record->colour);
}

bool has(const Database& database, const Pigment& pigment, PigmentWalk::IsSuch is_such) {
  return PigmentWalk(database, is_such).finds(pigment);
}

/// For a pigment that cannot be drawn: its preview colour, else the mean of the plain colours that it chooses from,
/// else grey.
Colour stand_in(const Database& database, const PatternedPigment& pigment) {
  if (pigment.quick_colour) return *pigment.quick_colour;
  Colour sum;
  int count = 0;
  if (pigment.map != kNoPigmentMap) {
    for (const PigmentEntry& entry : database.pigment_maps[index(pigment.map)]) {
      if (!entry.pigment.is_plain()) continue;
      sum.red += entry.pigment.colour.red;
      sum.green += entry.pigment.colour.green;
      sum.blue += entry.pigment.colour.blue;
      ++count;
    }
  }
  if (count == 0) return {0.5, 0.5, 0.5};
  return {sum.red / count, sum.green / count, sum.blue / count};
}

void make_opaque(const Database& database, Texture& texture) {
  if (is_patterned(database, texture.pigment)) {
    texture.pigment = {stand_in(database, database.pigments[index(texture.pigment.pattern)])};
  }
  Colour colour = database.colour(texture.pigment);
  colour.filter = colour.transmit = 0;
  texture.pigment = {colour};
}

/// Whether the texture is chosen by a pattern that cannot be drawn.
bool is_chosen_unseen(const Database& database, const Texture& texture) {
  if (texture.pattern == kNoTexturePattern) return false;
  const Pattern& pattern = database.texture_patterns[index(texture.pattern)].pattern;
  const auto* const inner = std::get_if<PigmentOperands>(&pattern.operands);
  return is_undrawable(pattern) || (inner && has(database, {.pattern = inner->pigment}, is_undrawable));
}

/// The first of the textures that the pattern chooses from.
void choose_first(const Database& database, Texture& texture) {
  while (is_chosen_unseen(database, texture)) {
    const TextureMapId map = database.texture_patterns[index(texture.pattern)].map;
    const Texture first = database.texture(database.texture_maps[index(map)][0].texture);
    texture = first;
  }
}

/// Of layers the lowest alone: what the others let through shows the next.
bool lets_light_through_it(const Database& database, const Texture& texture) {
  return texture.below == kNoTexture && texture.pattern == kNoTexturePattern &&
         has(database, texture.pigment, lets_light_through);
}

constexpr TextureFeature kTextureFeatures[] = {
    {"a texture chosen by a file, paving or the surface's slope", is_chosen_unseen, choose_first},
    {"a pigment by a file, paving or the surface's slope",
     [](const Database& database, const Texture& texture) { return has(database, texture.pigment, is_undrawable); },
     [](const Database& database, Texture& texture) {
       texture.pigment = {stand_in(database, database.pigments[index(texture.pigment.pattern)])};
     }},
    {"a transparent pigment", lets_light_through_it, make_opaque},
    {"`normal`", [](const Database&, const Texture& texture) { return texture.normal != kNoNormal; },
     [](const Database&, Texture& texture) { texture.normal = kNoNormal; }},
};

bool shines(const Colour& colour) { return colour.red != 0 || colour.green != 0 || colour.blue != 0; }

bool reflects(const Finish& finish) { return shines(finish.reflection.minimum) || shines(finish.reflection.maximum); }

// `conserve_energy`, `use_alpha` and `fresnel` are not here: they say nothing without transparency or reflection.
constexpr Feature<Finish> kFinishFeatures[] = {
    {"`reflection`", reflects, [](Finish& finish) { finish.reflection = {}; }},
    {"`emission`", [](const Finish& finish) { return shines(finish.emission); },
     [](Finish& finish) { finish.emission = {}; }},
    {"`diffuse` of light from behind", [](const Finish& finish) { return finish.diffuse_back != 0; },
     [](Finish& finish) { finish.diffuse_back = 0; }},
    {"`metallic`",
     [](const Finish& finish) { return finish.metallic != 0 && (finish.phong > 0 || finish.specular > 0); },
     [](Finish& finish) { finish.metallic = 0; }},
    {"`albedo`",
     [](const Finish& finish) { return finish.diffuse_albedo || finish.phong_albedo || finish.specular_albedo; },
     [](Finish& finish) { finish.diffuse_albedo = finish.phong_albedo = finish.specular_albedo = false; }},
    {"`irid`", [](const Finish& finish) { return finish.irid != 0; }, [](Finish& finish) { finish.irid = 0; }},
    {"`crand`", [](const Finish& finish) { return finish.crand != 0; }, [](Finish& finish) { finish.crand = 0; }},
};

}  // namespace

std::span<const TextureFeature> texture_features() { return kTextureFeatures; }
std::span<const Feature<Finish>> finish_features() { return kFinishFeatures; }

}  // namespace isl::scene
