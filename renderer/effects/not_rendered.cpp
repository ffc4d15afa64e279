#include "renderer/effects/not_rendered.h"

#include "renderer/effects/light_requests.h"
#include "renderer/effects/pigment_search.h"
#include "renderer/patterns/kinds/pattern_kind.h"

#include <optional>
#include <unordered_set>
#include <variant>

namespace isl::render {
namespace {

using scene::Database;
using scene::Pattern;
using scene::PatternedPigment;
using scene::PatternKind;
using scene::Pigment;
using scene::Texture;

/// The place of a statement, if there is one. The place may be unknown.
using Found = std::optional<OriginId>;

bool is_undrawable(const Pattern& pattern) { return info_of(pattern.kind).lack != PatternLack::nothing; }

bool is_undrawable(const Database&, const Pigment&, const PatternedPigment* record) {
  return record && is_undrawable(record->pattern);
}

Found find_undrawable(const Database& database, const Pigment& pigment) {
  return find_pigment(database, pigment, is_undrawable);
}

/// The place of the first pattern among the bumps that cannot be drawn; `seen` are the bumps that were looked at.
Found undrawable_bumps(const Database& database, scene::NormalId id, std::unordered_set<std::uint32_t>& seen) {
  if (id == scene::kNoNormal || !seen.insert(index(id)).second) return {};
  const scene::Normal& bumps = database.normals[index(id)];
  if (is_undrawable(bumps.pattern)) return bumps.pattern.said_at;
  if (const auto* const inner = std::get_if<scene::PigmentOperands>(&bumps.pattern.operands)) {
    if (const Found found = find_undrawable(database, {.pattern = inner->pigment})) return found;
  }
  if (bumps.map == scene::kNoNormalMap) return {};
  for (const scene::NormalEntry& entry : database.normal_maps[index(bumps.map)]) {
    if (const Found found = undrawable_bumps(database, entry.normal, seen)) return found;
  }
  return {};
}

/// The place of the pattern that cannot be drawn and that chooses the texture.
Found chosen_unseen(const Database& database, const Texture& texture) {
  if (texture.pattern == scene::kNoTexturePattern) return {};
  const Pattern& pattern = database.texture_patterns[index(texture.pattern)].pattern;
  if (is_undrawable(pattern)) return pattern.said_at;
  const auto* const inner = std::get_if<scene::PigmentOperands>(&pattern.operands);
  return inner ? find_undrawable(database, {.pattern = inner->pigment}) : Found();
}

/// Takes the first of the textures that the pattern chooses from.
void choose_first(const Database& database, Texture& texture) {
  while (chosen_unseen(database, texture)) {
    const scene::TextureMapId map = database.texture_patterns[index(texture.pattern)].map;
    const Texture first = database.texture(database.texture_maps[index(map)][0].texture);
    texture = first;
  }
}

/// A texture refers to other columns, so both functions need the database.
struct TextureRow {
  std::string_view name, summary;
  std::string_view what;  ///< as the language writes it, for refusals
  Found (*find)(const Database&, const Texture&);
  void (*leave_out)(const Database&, Texture&);
  int from_quality = 0;
};

constexpr TextureRow kTextureRows[] = {
    {"texture_by_file", "textures that depend on a density", "a texture that depends on a density file", chosen_unseen,
     choose_first},
    {"pigment_by_file", "pigments that depend on a density", "a pigment that depends on a density file",
     [](const Database& database, const Texture& texture) { return find_undrawable(database, texture.pigment); },
     [](const Database& database, Texture& texture) {
       texture.pigment = {stand_in(database, database.pigments[index(texture.pigment.pattern)])};
     }},
    {"normal_by_file", "bumps that depend on a density", "a `normal` that depends on a density file",
     [](const Database& database, const Texture& texture) {
       std::unordered_set<std::uint32_t> seen;
       return undrawable_bumps(database, texture.normal, seen);
     },
     [](const Database&, Texture& texture) { texture.normal = scene::kNoNormal; }, 8},
};

Effect texture_effect(const TextureRow& row) {
  return {.name = row.name,
          .summary = row.summary,
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

}  // namespace

std::vector<Effect> effects_not_rendered() {
  std::vector<Effect> effects;
  for (const TextureRow& row : kTextureRows) effects.push_back(texture_effect(row));
  for (Effect& effect : effects) effect.is_rendered = false;
  return effects;
}

}  // namespace isl::render
