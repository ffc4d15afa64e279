#include "renderer/scene/clear_textures.h"

#include "renderer/scene/image_transparency.h"
#include "renderer/scene/remembered.h"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace isl::scene {
namespace {

/// Each record is visited once. References have no cycles, since a record is made after those that it refers to.
class ClearSearch {
 public:
  explicit ClearSearch(const Database& database)
      : database_(database), textures_(database.textures.size()), pigments_(database.pigments.size()) {}

  /// The layers above the lowest let light through to that one only.
  bool is_clear(const Texture& texture) {
    if (texture.pattern != kNoTexturePattern) {
      const TextureMap& map = database_.texture_maps[index(database_.texture_patterns[index(texture.pattern)].map)];
      return std::ranges::any_of(map, [&](const TextureEntry& entry) { return is_clear(entry.texture); });
    }
    return texture.below == kNoTexture ? is_clear(texture.pigment) : is_clear(texture.below);
  }

  bool is_clear(TextureId id) {
    if (id == kNoTexture) return remembered(default_, [&] { return is_clear(database_.default_texture); });
    return remembered(textures_[index(id)], [&] { return is_clear(database_.textures[index(id)]); });
  }

 private:
  static bool is_clear(const Colour& colour) { return colour.filter != 0 || colour.transmit != 0; }

  bool is_clear(const Pigment& pigment) {
    if (pigment.is_plain()) return is_clear(pigment.colour);
    return remembered(pigments_[index(pigment.pattern)],
                      [&] { return is_clear(database_.pigments[index(pigment.pattern)]); });
  }

  bool is_clear(const PatternedPigment& pigment) {
    const Pattern& pattern = pigment.pattern;
    if (pattern.kind == PatternKind::plain) return is_clear(pigment.colour);
    const auto* const image = std::get_if<ImageId>(&pattern.operands);
    if (image && may_be_transparent(database_.images[index(*image)])) return true;
    const auto* const colour = std::get_if<ColourOperands>(&pattern.operands);
    if (colour && may_be_transparent(*colour)) return true;
    const auto* const inner = std::get_if<PigmentOperands>(&pattern.operands);
    if (inner && is_clear(Pigment{.pattern = inner->pigment})) return true;
    if (pigment.map == kNoPigmentMap) return false;
    return std::ranges::any_of(database_.pigment_maps[index(pigment.map)],
                               [&](const PigmentEntry& entry) { return is_clear(entry.pigment); });
  }

  const Database& database_;
  std::vector<Answer> textures_, pigments_;
  Answer default_;
};

}  // namespace

ClearTextures::ClearTextures(const Database& database) {
  ClearSearch search(database);
  is_clear_.reserve(database.textures.size() + 1);
  for (std::uint32_t i = 0; i < database.textures.size(); ++i) is_clear_.push_back(search.is_clear(TextureId{i}));
  is_clear_.push_back(search.is_clear(kNoTexture));
  any_ = std::ranges::find(is_clear_, true) != is_clear_.end();
  if (!any_) is_clear_.clear();
}

}  // namespace isl::scene
