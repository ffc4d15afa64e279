#include "renderer/effects/scene_use.h"

#include <cstddef>
#include <type_traits>

namespace isl::render {
namespace {

OriginId own_or(OriginId own, OriginId other) { return own.value != 0 ? own : other; }

}  // namespace

SceneUse::SceneUse(const scene::Database& database) : database_(database) {
  std::size_t i = 0;
  scene::for_each_column([&](const auto& column) { is_reached_[i++].resize((database.*column.records).size()); });
  scene::for_each_root(database, [this](const auto& record) {
    if constexpr (requires { record.origin; }) {
      follow(record, record.origin);
    } else {
      follow(record, OriginId{});
    }
  });
  // Records are followed in the order in which they were met, so that the first statement is the first of the walk. A
  // list is used, so that depth costs no stack.
  for (std::size_t next = 0; next < pending_.size(); ++next) {
    const Pending pending = pending_[next];
    pending.follow(*this, pending.record, pending.origin);
  }
  pending_ = {};
}

template <class Id>
void SceneUse::reach(Id id, OriginId origin) {
  constexpr std::size_t kColumn = scene::column_of<Id>();
  if (index(id) == scene::kNone || is_reached_[kColumn][index(id)]) return;
  is_reached_[kColumn][index(id)] = true;
  pending_.push_back({[](SceneUse& self, std::uint32_t record, OriginId from) {
                        self.follow((self.database_.*std::get<kColumn>(scene::kColumns).records)[record], from);
                      },
                      index(id), origin});
}

template <class Record>
void SceneUse::follow(const Record& record, OriginId origin) {
  if constexpr (scene::HasEdges<const Record>) {
    scene::for_each_edge(record, [&](const auto& id) { reach(id, origin); });
  }
}

void SceneUse::follow(const scene::Object& object, OriginId origin) {
  const OriginId own = own_or(object.origin, origin);
  objects_.push_back({&object, own});
  scene::for_each_edge(object, [&](const auto& id) { reach(id, own); });
}

void SceneUse::follow(const scene::Light& light, OriginId origin) {
  const OriginId own = own_or(light.origin, origin);
  lights_.push_back({&light, own});
  scene::for_each_edge(light, [&](const auto& id) { reach(id, own); });
}

void SceneUse::follow(const scene::Group& group, OriginId origin) {
  groups_.push_back({&group, origin});
  for (const scene::Light& light : group.lights) follow(light, origin);
  for (const scene::Object& child : group.children) follow(child, origin);
}

void SceneUse::follow(const scene::Blob& blob, OriginId origin) {
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    const OriginId own = i < blob.origins.size() ? own_or(blob.origins[i], origin) : origin;
    scene::for_each_edge(blob.components[i], [&](const auto& id) { reach(id, own); });
  }
}

void SceneUse::follow(const scene::Texture& texture, OriginId origin) {
  const OriginId own = own_or(texture.named_at, origin);
  textures_.push_back({&texture, own});
  scene::for_each_edge(texture, [&](const auto& id) { reach(id, own); });
}

void SceneUse::follow(const scene::Finish& finish, OriginId origin) {
  finishes_.push_back({&finish, own_or(origin, finish.named_at)});
}

void SceneUse::follow(const scene::Interior& interior, OriginId origin) { interiors_.push_back({&interior, origin}); }

void SceneUse::follow(const scene::Image& image, OriginId origin) {
  images_.push_back({&image, origin});
  scene::for_each_edge(image, [&](const auto& id) { reach(id, origin); });
}

}  // namespace isl::render
