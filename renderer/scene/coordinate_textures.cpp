#include "renderer/scene/coordinate_textures.h"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace isl::scene {
namespace {

/// Each record is looked at once. A record never refers to itself, however far round: it is made after what it names.
class Walk {
 public:
  explicit Walk(const Database& database)
      : database_(database),
        textures_(database.textures.size(), Answer::unknown),
        pigments_(database.pigments.size(), Answer::unknown),
        normals_(database.normals.size(), Answer::unknown) {}

  bool asks(const Texture& texture) {
    if (texture.uv_mapping != 0 || asks(texture.pigment) || asks(texture.normal)) return true;
    if (texture.below != kNoTexture && asks(texture.below)) return true;
    if (texture.pattern == kNoTexturePattern) return false;
    const TexturePattern& record = database_.texture_patterns[index(texture.pattern)];
    if (asks(record.pattern)) return true;
    return record.map != kNoTextureMap && any_of(database_.texture_maps[index(record.map)], &TextureEntry::texture);
  }

  bool asks(TextureId id) {
    return id != kNoTexture && known(textures_[index(id)], [&] { return asks(database_.textures[index(id)]); });
  }

 private:
  enum class Answer : std::uint8_t { unknown, no, yes };

  template <class Ask>
  static bool known(Answer& answer, const Ask& ask) {
    if (answer == Answer::unknown) answer = ask() ? Answer::yes : Answer::no;
    return answer == Answer::yes;
  }

  template <class Entry, class Member>
  bool any_of(const std::vector<Entry>& map, Member Entry::*member) {
    return std::ranges::any_of(map, [&](const Entry& entry) { return asks(entry.*member); });
  }

  bool asks(const Pattern& pattern) {
    if (pattern.uv_mapping) return true;
    const auto* const inner = std::get_if<PigmentOperands>(&pattern.operands);
    return inner != nullptr && asks(Pigment{.pattern = inner->pigment});
  }

  bool asks(const Pigment& pigment) {
    if (pigment.is_plain()) return false;
    return known(pigments_[index(pigment.pattern)], [&] {
      const PatternedPigment& record = database_.pigments[index(pigment.pattern)];
      if (asks(record.pattern)) return true;
      return record.map != kNoPigmentMap && any_of(database_.pigment_maps[index(record.map)], &PigmentEntry::pigment);
    });
  }

  bool asks(NormalId id) {
    if (id == kNoNormal) return false;
    return known(normals_[index(id)], [&] {
      const Normal& record = database_.normals[index(id)];
      if (asks(record.pattern)) return true;
      return record.map != kNoNormalMap && any_of(database_.normal_maps[index(record.map)], &NormalEntry::normal);
    });
  }

  const Database& database_;
  std::vector<Answer> textures_, pigments_, normals_;
};

}  // namespace

CoordinateTextures::CoordinateTextures(const Database& database) {
  Walk walk(database);
  asks_.reserve(database.textures.size() + 1);
  for (std::uint32_t i = 0; i < database.textures.size(); ++i) asks_.push_back(walk.asks(TextureId{i}));
  asks_.push_back(walk.asks(database.default_texture));
  any_ = std::ranges::find(asks_, true) != asks_.end();
  if (!any_) asks_.clear();
}

}  // namespace isl::scene
