#include "renderer/queries/subset.h"

#include "renderer/scene/edges.h"

#include <unordered_map>
#include <vector>

namespace isl::render {
namespace {

using scene::Object;

/// Copies records and gives them new numbers. Records that are shared stay shared.
class Copier {
 public:
  Copier(const scene::Database& from, Charge& charge) : from_(from), charge_(charge) { to_.kernels = from.kernels; }

  std::optional<scene::Database> copy(const Object& object) {
    Object root = bare(object);
    root.parent_from_object = {};
    root.shape = shape(root);
    root.clip = clip(root.clip);
    to_.objects.push_back(root);
    // Groups hold groups. A list holds those whose children are still to be copied, so that depth costs no stack.
    for (std::size_t next = 0; next < pending_.size(); ++next) {
      std::vector<Object> children;
      hold(2 * from_.groups[pending_[next]].children.size() * sizeof(Object));
      if (is_refused_) return std::nullopt;
      for (const Object& child : from_.groups[pending_[next]].children) {
        Object copied = bare(child);
        copied.shape = shape(copied);
        copied.clip = clip(copied.clip);
        children.push_back(copied);
      }
      to_.groups[next].children = std::move(children);
    }
    if (is_refused_) return std::nullopt;
    return std::move(to_);
  }

 private:
  /// Counts the memory of a copy before it is made.
  void hold(std::size_t bytes) { is_refused_ = is_refused_ || !charge_.grow(bytes); }

  static Object bare(const Object& object) {
    Object result;
    result.kind = object.kind;
    result.shape = object.shape;
    result.inverse = object.inverse;
    result.parent_from_object = object.parent_from_object;
    result.clip = object.clip;
    return result;
  }

  std::uint32_t shape(const Object& object) {
    switch (object.kind) {
      case Object::Kind::solid: return solid(object.shape);
      case Object::Kind::blob: return blob(object.shape);
      case Object::Kind::group: break;
    }
    return group(object.shape);
  }

  scene::GroupId clip(scene::GroupId clip) {
    return clip == scene::kNoGroup ? clip : scene::GroupId{group(index(clip))};
  }

  std::uint32_t group(std::uint32_t i) {
    const auto [place, is_new] = groups_.try_emplace(i, static_cast<std::uint32_t>(to_.groups.size()));
    if (is_new) {
      pending_.push_back(i);
      to_.groups.push_back({.operation = from_.groups[i].operation});
    }
    return place->second;
  }

  std::uint32_t blob(std::uint32_t i) {
    const auto [place, is_new] = blobs_.try_emplace(i, static_cast<std::uint32_t>(to_.blobs.size()));
    if (!is_new) return place->second;
    const std::size_t parts = from_.blobs[i].components.size();
    hold(parts * (sizeof(scene::Component) + sizeof(scene::Transform) + sizeof(scene::Vec3) + 2 * sizeof(OriginId)));
    if (is_refused_) return 0;
    scene::Blob& copied = to_.blobs.emplace_back(from_.blobs[i]);
    for (scene::Component& c : copied.components) {
      c.texture = scene::kNoTexture;
      if (c.transform == scene::kIdentity) continue;
      to_.transforms.push_back(from_.transforms[index(c.transform)]);
      c.transform = scene::TransformId{static_cast<std::uint32_t>(to_.transforms.size() - 1)};
    }
    return place->second;
  }

  std::uint32_t solid(std::uint32_t i) {
    hold(2 * sizeof(scene::Solid));
    scene::Solid& copied = to_.solids.emplace_back(from_.solids[i]);
    for_each_edge(copied, [this]<class Id>(Id& detail) {
      constexpr auto records = std::get<scene::column_of<Id>()>(scene::kColumns).records;
      (to_.*records).push_back((from_.*records)[scene::index(detail)]);
      detail = Id{static_cast<std::uint32_t>((to_.*records).size() - 1)};
    });
    return static_cast<std::uint32_t>(to_.solids.size() - 1);
  }

  const scene::Database& from_;
  Charge& charge_;
  bool is_refused_ = false;
  scene::Database to_;
  std::unordered_map<std::uint32_t, std::uint32_t> groups_, blobs_;  ///< new numbers, by number in from_
  std::vector<std::uint32_t> pending_;                               ///< groups of from_, in the order of to_'s
};

}  // namespace

std::optional<scene::Database> subset(const scene::Database& database, const Object& object, Charge& charge) {
  return Copier(database, charge).copy(object);
}

}  // namespace isl::render
