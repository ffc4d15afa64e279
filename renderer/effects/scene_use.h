// The records of a scene that are in use: those that the world refers to, each once, with the place of its first use.
#pragma once

#include "renderer/scene/edges.h"

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace isl::render {

template <class Record>
struct Use {
  const Record* record;
  OriginId user;  ///< for a texture or finish that has a name in the scene: the name; else the object or component
};

class SceneUse {
 public:
  explicit SceneUse(const scene::Database& database);

  [[nodiscard]] const scene::Database& database() const { return database_; }
  /// Objects in the world and in groups; those of a group come once.
  [[nodiscard]] std::span<const Use<scene::Object>> objects() const { return objects_; }
  [[nodiscard]] std::span<const Use<scene::Light>> lights() const { return lights_; }
  [[nodiscard]] std::span<const Use<scene::Group>> groups() const { return groups_; }
  [[nodiscard]] std::span<const Use<scene::Texture>> textures() const { return textures_; }
  [[nodiscard]] std::span<const Use<scene::Finish>> finishes() const { return finishes_; }
  [[nodiscard]] std::span<const Use<scene::Interior>> interiors() const { return interiors_; }
  [[nodiscard]] std::span<const Use<scene::Image>> images() const { return images_; }

 private:
  struct Pending {
    void (*follow)(SceneUse&, std::uint32_t, OriginId);
    std::uint32_t record;
    OriginId origin;
  };

  template <class Id>
  void reach(Id id, OriginId origin);
  template <class Record>
  void follow(const Record& record, OriginId origin);
  void follow(const scene::Object& object, OriginId origin);
  void follow(const scene::Light& light, OriginId origin);
  void follow(const scene::Group& group, OriginId origin);
  void follow(const scene::Blob& blob, OriginId origin);
  void follow(const scene::Texture& texture, OriginId origin);
  void follow(const scene::Finish& finish, OriginId origin);
  void follow(const scene::Interior& interior, OriginId origin);
  void follow(const scene::Image& image, OriginId origin);

  const scene::Database& database_;
  std::vector<Use<scene::Object>> objects_;
  std::vector<Use<scene::Light>> lights_;
  std::vector<Use<scene::Group>> groups_;
  std::vector<Use<scene::Texture>> textures_;
  std::vector<Use<scene::Finish>> finishes_;
  std::vector<Use<scene::Interior>> interiors_;
  std::vector<Use<scene::Image>> images_;
  std::array<std::vector<bool>, std::tuple_size_v<decltype(scene::kColumns)>> is_reached_;
  std::vector<Pending> pending_;
};

}  // namespace isl::render
