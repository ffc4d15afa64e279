// Finds equal textures, so that a thousand spheres of one colour share one record of the database.
#pragma once

#include "renderer/scene/database.h"

#include <cstdint>
#include <cstring>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isl::interpreter {

class TextureTable {
 public:
  /// The index in `textures` of one that is bitwise equal; appended if there is none.
  [[nodiscard]] std::uint32_t find_or_add(const scene::Texture& texture, std::vector<scene::Texture>& textures) {
    // Neighbours in a scene mostly share theirs.
    if (last_ < textures.size() && is_same(textures[last_], texture)) return last_;
    const auto next = static_cast<std::uint32_t>(textures.size());
    const std::size_t hash = std::hash<std::string_view>()(bytes(texture));
    const auto [first, end] = by_hash_.equal_range(hash);
    for (auto it = first; it != end; ++it) {
      if (is_same(textures[it->second], texture)) return last_ = it->second;
    }
    by_hash_.emplace(hash, next);
    textures.push_back(texture);
    return last_ = next;
  }

 private:
  // Nothing but doubles: no padding that could differ.
  static_assert(std::is_trivially_copyable_v<scene::Texture> && sizeof(scene::Texture) % sizeof(double) == 0);
  [[nodiscard]] static std::string_view bytes(const scene::Texture& texture) {
    return {reinterpret_cast<const char*>(&texture), sizeof(texture)};
  }
  [[nodiscard]] static bool is_same(const scene::Texture& a, const scene::Texture& b) {
    return std::memcmp(&a, &b, sizeof(a)) == 0;
  }

  std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;
  std::uint32_t last_ = 0;
};

}  // namespace isl::interpreter
