#include "renderer/effects/not_rendered.h"

#include "renderer/effects/light_requests.h"
#include "renderer/patterns/kinds/pattern_kind.h"

#include <optional>
#include <unordered_set>
#include <variant>

namespace isl::render {
namespace {

using scene::Colour;
using scene::Database;
using scene::Finish;
using scene::Pattern;
using scene::PatternedPigment;
using scene::PatternKind;
using scene::Pigment;
using scene::PigmentEntry;
using scene::Texture;

bool is_transparent(const Colour& colour) { return colour.filter != 0 || colour.transmit != 0; }

bool is_patterned(const Database& database, const Pigment& pigment) {
  return !pigment.is_plain() && database.pigments[index(pigment.pattern)].pattern.kind != PatternKind::plain;
}

/// The place of a statement, if there is one. The place may be unknown.
using Found = std::optional<OriginId>;

/// Finds the first of the pigments that one is made of, itself included, for which `is_such` holds. Each is looked at
/// once.
class PigmentWalk {
 public:
  using IsSuch = bool (*)(const Pigment&, const PatternedPigment*);
  PigmentWalk(const Database& database, IsSuch is_such) : database_(database), is_such_(is_such) {}

  Found find(const Pigment& pigment) {
    if (pigment.is_plain()) return is_such_(pigment, nullptr) ? Found(pigment.said_at) : Found();
    if (!seen_.insert(index(pigment.pattern)).second) return {};
    const PatternedPigment& record = database_.pigments[index(pigment.pattern)];
    if (is_such_(pigment, &record)) return record.pattern.said_at;
    if (const auto* const inner = std::get_if<scene::PigmentOperands>(&record.pattern.operands)) {
      if (const Found found = find({.pattern = inner->pigment})) return found;
    }
    if (record.map == scene::kNoPigmentMap) return {};
    for (const PigmentEntry& entry : database_.pigment_maps[index(record.map)]) {
      if (const Found found = find(entry.pigment)) return found;
    }
    return {};
  }

 private:
  const Database& database_;
  IsSuch is_such_;
  std::unordered_set<std::uint32_t> seen_;
};

bool is_undrawable(const Pattern& pattern) { return info_of(pattern.kind).lack != PatternLack::nothing; }

bool is_undrawable(const Pigment&, const PatternedPigment* record) { return record && is_undrawable(record->pattern); }

bool lets_light_through(const Pigment& pigment, const PatternedPigment* record) {
  if (!record) return is_transparent(pigment.colour);
  return record->pattern.kind == PatternKind::plain && is_transparent(record->colour);
}

Found find_in(const Database& database, const Pigment& pigment, PigmentWalk::IsSuch is_such) {
  return PigmentWalk(database, is_such).find(pigment);
}

/// Replaces a pigment that cannot be drawn: by its preview colour, else by the mean of the plain colours that it
/// chooses from, else by grey.
Colour stand_in(const Database& database, const PatternedPigment& pigment) {
  if (pigment.quick_colour) return *pigment.quick_colour;
  Colour sum;
  int count = 0;
  if (pigment.map != scene::kNoPigmentMap) {
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

/// The place of the pattern that cannot be drawn and that chooses the texture.
Found chosen_unseen(const Database& database, const Texture& texture) {
  if (texture.pattern == scene::kNoTexturePattern) return {};
  const Pattern& pattern = database.texture_patterns[index(texture.pattern)].pattern;
  if (is_undrawable(pattern)) return pattern.said_at;
  const auto* const inner = std::get_if<scene::PigmentOperands>(&pattern.operands);
  return inner ? find_in(database, {.pattern = inner->pigment}, is_undrawable) : Found();
}

/// Takes the first of the textures that the pattern chooses from.
void choose_first(const Database& database, Texture& texture) {
  while (chosen_unseen(database, texture)) {
    const scene::TextureMapId map = database.texture_patterns[index(texture.pattern)].map;
    const Texture first = database.texture(database.texture_maps[index(map)][0].texture);
    texture = first;
  }
}

/// Layers above the lowest do not count: they let the next one show through.
Found transparent_part(const Database& database, const Texture& texture) {
  if (texture.below != scene::kNoTexture || texture.pattern != scene::kNoTexturePattern) return {};
  return find_in(database, texture.pigment, lets_light_through);
}

/// A texture refers to other columns, so both functions need the database.
struct TextureRow {
  std::string_view name, summary;
  std::string_view what;  ///< as the language writes it, for refusals
  Found (*find)(const Database&, const Texture&);
  void (*leave_out)(const Database&, Texture&);
  int from_quality = 0;
  std::string_view rays = {};
};

constexpr TextureRow kTextureRows[] = {
    {"texture_by_surface", "textures that depend on a file or slope",
     "a texture that depends on a file or the surface's slope", chosen_unseen, choose_first},
    {"pigment_by_surface", "pigments that depend on a file or slope",
     "a pigment that depends on a file or the surface's slope",
     [](const Database& database, const Texture& texture) { return find_in(database, texture.pigment, is_undrawable); },
     [](const Database& database, Texture& texture) {
       texture.pigment = {stand_in(database, database.pigments[index(texture.pigment.pattern)])};
     }},
    {"transparency", "surfaces that let light through", "a transparent pigment", transparent_part, make_opaque, 6,
     "refraction"},
    {"normal", "bumps", "`normal`",
     [](const Database& database, const Texture& texture) {
       if (texture.normal == scene::kNoNormal) return Found();
       return Found(database.normals[index(texture.normal)].pattern.said_at);
     },
     [](const Database&, Texture& texture) { texture.normal = scene::kNoNormal; }, 8},
};

struct FinishRow {
  std::string_view name, summary;
  std::string_view what;
  scene::FinishItem item;
  bool (*is_used)(const Finish&);
  void (*leave_out)(Finish&);
  int from_quality = 2;
};

// `conserve_energy` and `use_alpha` are not here, because they have no meaning without transparency.
constexpr FinishRow kFinishRows[] = {
    {"fresnel", "reflection computed from the ior", "`fresnel` reflection", scene::FinishItem::fresnel,
     [](const Finish& finish) { return reflects(finish) && finish.fresnel; },
     [](Finish& finish) { finish.fresnel = false; }, 8},
    {"reflection_exponent", "an exponent for the reflected light", "`exponent` of a reflection",
     scene::FinishItem::exponent,
     [](const Finish& finish) { return reflects(finish) && finish.reflection.exponent != 1; },
     [](Finish& finish) { finish.reflection.exponent = 1; }, 8},
    {"emission", "surfaces that shine by themselves", "`emission`", scene::FinishItem::emission,
     [](const Finish& finish) { return shines(finish.emission); }, [](Finish& finish) { finish.emission = {}; }},
    {"diffuse_back", "surfaces lit from behind", "`diffuse` of light from behind", scene::FinishItem::diffuse,
     [](const Finish& finish) { return finish.diffuse_back != 0; }, [](Finish& finish) { finish.diffuse_back = 0; }},
    {"albedo", "finishes given by their total reflected light", "`albedo`", scene::FinishItem::diffuse,
     [](const Finish& finish) { return finish.diffuse_albedo || finish.phong_albedo || finish.specular_albedo; },
     [](Finish& finish) { finish.diffuse_albedo = finish.phong_albedo = finish.specular_albedo = false; }},
    {"irid", "colours of thin films", "`irid`", scene::FinishItem::irid,
     [](const Finish& finish) { return finish.irid != 0; }, [](Finish& finish) { finish.irid = 0; }},
    {"crand", "grain", "`crand`", scene::FinishItem::crand, [](const Finish& finish) { return finish.crand != 0; },
     [](Finish& finish) { finish.crand = 0; }},
};

Effect texture_effect(const TextureRow& row) {
  return {.name = row.name,
          .summary = row.summary,
          .rays = row.rays,
          .from_quality = row.from_quality,
          .find =
              [&row](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                for (const Use<Texture>& texture : use.textures()) {
                  if (const Found word = row.find(use.database(), *texture.record))
                    requests.add(row.what, *word, texture.user);
                }
              },
          .leave_out =
              [&row](Database& database) {
                const auto leave_out = [&](Texture& texture) {
                  if (row.find(database, texture)) row.leave_out(database, texture);
                };
                leave_out(database.default_texture);
                for (Texture& texture : database.textures) leave_out(texture);
              }};
}

Effect finish_effect(const FinishRow& row) {
  return {.name = row.name,
          .summary = row.summary,
          .from_quality = row.from_quality,
          .find =
              [&row](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                for (const Use<Finish>& finish : use.finishes()) {
                  if (row.is_used(*finish.record))
                    requests.add(row.what, finish.record->said_at[row.item], finish.user);
                }
              },
          .leave_out =
              [&row](Database& database) {
                for (Finish& finish : database.finishes) {
                  if (row.is_used(finish)) row.leave_out(finish);
                }
              }};
}

}  // namespace

void add_surfaces_not_rendered(std::vector<Effect>& effects) {
  for (const TextureRow& row : kTextureRows) effects.push_back(texture_effect(row));
  for (const FinishRow& row : kFinishRows) effects.push_back(finish_effect(row));
}

}  // namespace isl::render
