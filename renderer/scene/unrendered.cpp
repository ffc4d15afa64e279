#include "renderer/scene/unrendered.h"

#include "renderer/scene/unrendered_features.h"
#include "renderer/scene/unrendered_textures.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace isl::scene {
namespace {

/// Walks what stands in the world, each shared group once.
class Finder {
 public:
  explicit Finder(const Database& database) : database_(database), is_seen_(database.groups.size(), false) {}

  std::vector<Unrendered> find() {
    if (database_.camera) look(camera_features(), *database_.camera, database_.camera->origin);
    look_at(database_.lights);
    for (const WorldFeature& feature : world_features()) {
      if (const std::size_t count = feature.count(database_); count > 0)
        add(feature.what, feature.origin(database_), count);
    }
    look_at(database_.default_texture, {});
    look_at(database_.objects);
    // Groups hold groups: a list of what is still to be looked at, so that depth costs no stack.
    for (std::size_t next = 0; next < groups_.size(); ++next) {
      const Group& group = database_.groups[groups_[next].shape];
      look(group_features(), group, groups_[next].origin);
      look_at(group.lights);
      look_at(group.children);
    }
    return std::move(found_);
  }

 private:
  struct PlacedGroup {
    std::uint32_t shape;
    OriginId origin;
  };

  void add(std::string_view what, OriginId origin, std::uint64_t count = 1) {
    const auto [place, is_new] = places_.try_emplace(what, found_.size());
    if (is_new) found_.push_back({std::string(what), origin, 0});
    found_[place->second].count += count;
  }

  template <class Record>
  void look(std::span<const Feature<Record>> features, const Record& record, OriginId origin) {
    for (const Feature<Record>& feature : features) {
      if (feature.is_used(record)) add(feature.what, origin);
    }
  }

  /// With its layers and what it is chosen from: each feature counts once, however many of these have it.
  void look_at(const Texture& texture, OriginId origin) {
    const std::vector<Texture> parts = parts_of(texture);
    for (const TextureFeature& feature : texture_features()) {
      if (std::ranges::any_of(parts, [&](const Texture& part) { return feature.is_used(database_, part); }))
        add(feature.what, origin);
    }
    for (const Feature<Finish>& feature : finish_features()) {
      const auto uses = [&](const Texture& part) { return feature.is_used(database_.finish(part.finish)); };
      if (std::ranges::any_of(parts, uses)) add(feature.what, origin);
    }
  }

  /// The texture and every record that it names, however far down, each once.
  std::vector<Texture> parts_of(const Texture& texture) const {
    std::vector<Texture> parts{texture};
    std::unordered_set<std::uint32_t> seen;
    const auto take = [&](TextureId id) {
      if (id != kNoTexture && seen.insert(index(id)).second) parts.push_back(database_.textures[index(id)]);
    };
    for (std::size_t next = 0; next < parts.size(); ++next) {
      const Texture part = parts[next];
      take(part.below);
      if (part.pattern == kNoTexturePattern) continue;
      const TextureMapId map = database_.texture_patterns[index(part.pattern)].map;
      if (map == kNoTextureMap) continue;
      for (const TextureEntry& entry : database_.texture_maps[index(map)]) take(entry.texture);
    }
    return parts;
  }

  void look_at(const std::vector<Light>& lights) {
    for (const Light& light : lights) look(light_features(), light, light.origin);
  }

  void look_at(const std::vector<Object>& objects) {
    for (const Object& object : objects) {
      look(object_features(), object, object.origin);
      if (object.texture != kNoTexture) look_at(database_.texture(object.texture), object.origin);
      if (object.kind == Object::Kind::blob) look_at(database_.blobs[object.shape]);
      if (object.kind != Object::Kind::group || is_seen_[object.shape]) continue;
      is_seen_[object.shape] = true;
      groups_.push_back({object.shape, object.origin});
    }
  }

  void look_at(const Blob& blob) {
    for (std::size_t i = 0; i < blob.components.size(); ++i) {
      const TextureId texture = blob.components[i].texture;
      if (texture != kNoTexture) look_at(database_.texture(texture), blob.origins[i]);
    }
  }

  const Database& database_;
  std::vector<Unrendered> found_;
  std::unordered_map<std::string_view, std::size_t> places_;  ///< in found_
  std::vector<bool> is_seen_;                                 ///< by group
  std::vector<PlacedGroup> groups_;                           ///< in the order in which they were met
};

template <class Record>
void leave_out(std::span<const Feature<Record>> features, Record& record) {
  for (const Feature<Record>& feature : features) {
    if (feature.is_used(record)) feature.leave_out(record);
  }
}

template <class Record>
void leave_out(std::span<const Feature<Record>> features, std::vector<Record>& records) {
  for (Record& record : records) leave_out(features, record);
}

void leave_out(const Database& database, Texture& texture) {
  for (const TextureFeature& feature : texture_features()) {
    if (feature.is_used(database, texture)) feature.leave_out(database, texture);
  }
}

}  // namespace

std::vector<Unrendered> unrendered(const Database& database) { return Finder(database).find(); }

void leave_out_unrendered(Database& database) {
  if (database.camera) leave_out(camera_features(), *database.camera);
  leave_out(light_features(), database.lights);
  for (const WorldFeature& feature : world_features()) {
    if (feature.count(database) > 0) feature.leave_out(database);
  }
  leave_out(database, database.default_texture);
  for (Texture& texture : database.textures) leave_out(database, texture);
  leave_out(finish_features(), database.finishes);
  leave_out(object_features(), database.objects);
  for (Group& group : database.groups) {
    leave_out(object_features(), group.children);
    leave_out(light_features(), group.lights);
  }
  leave_out(group_features(), database.groups);
}

}  // namespace isl::scene
