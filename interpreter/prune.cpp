#include "interpreter/prune.h"

#include <cstdint>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Database;
using scene::Object;

/// One column of the database: which of its records are reached, then where each went.
class Column {
 public:
  explicit Column(std::size_t size) : places_(size, scene::kNone) {}

  /// True the first time.
  bool reach(std::uint32_t i) {
    const bool is_new = places_[i] == scene::kNone;
    places_[i] = 0;
    return is_new;
  }
  [[nodiscard]] std::uint32_t place(std::uint32_t i) const { return places_[i]; }

  /// Keeps the records that are reached.
  template <class Record>
  void compact(std::vector<Record>& records) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (places_[i] == scene::kNone) continue;
      places_[i] = next;
      if (next != i) records[next] = std::move(records[i]);
      ++next;
    }
    records.resize(next);
  }

 private:
  std::vector<std::uint32_t> places_;
};

class Pruner {
 public:
  explicit Pruner(Database& database)
      : database_(database),
        blobs_(database.blobs.size()),
        solids_(database.solids.size()),
        groups_(database.groups.size()),
        textures_(database.textures.size()),
        transforms_(database.transforms.size()),
        kernels_(database.kernels.size()) {}

  void run() {
    reach(database_.objects);
    // Groups hold groups: a list of what is still to be looked at, so that depth costs no stack.
    while (!pending_.empty()) {
      const std::uint32_t group = pending_.back();
      pending_.pop_back();
      reach(database_.groups[group].children);
    }
    blobs_.compact(database_.blobs);
    solids_.compact(database_.solids);
    groups_.compact(database_.groups);
    textures_.compact(database_.textures);
    transforms_.compact(database_.transforms);
    kernels_.compact(database_.kernels);
    renumber(database_.objects);
    for (scene::Group& group : database_.groups) renumber(group.children);
    for (scene::Blob& blob : database_.blobs) renumber(blob);
  }

 private:
  void reach(const std::vector<Object>& objects) {
    for (const Object& object : objects) {
      if (object.texture != scene::kNoTexture) textures_.reach(index(object.texture));
      switch (object.kind) {
        case Object::Kind::solid: solids_.reach(object.shape); break;
        case Object::Kind::group:
          if (groups_.reach(object.shape)) pending_.push_back(object.shape);
          break;
        case Object::Kind::blob:
          if (blobs_.reach(object.shape)) reach(database_.blobs[object.shape]);
          break;
      }
    }
  }

  void reach(const scene::Blob& blob) {
    for (const scene::Component& component : blob.components) {
      if (component.texture != scene::kNoTexture) textures_.reach(index(component.texture));
      if (component.transform != scene::kIdentity) transforms_.reach(index(component.transform));
      kernels_.reach(index(component.kernel));
    }
  }

  void renumber(std::vector<Object>& objects) {
    for (Object& object : objects) {
      const Column& column = object.kind == Object::Kind::solid  ? solids_
                             : object.kind == Object::Kind::blob ? blobs_
                                                                 : groups_;
      object.shape = column.place(object.shape);
      if (object.texture != scene::kNoTexture)
        object.texture = scene::TextureId{textures_.place(index(object.texture))};
    }
  }

  void renumber(scene::Blob& blob) {
    for (scene::Component& c : blob.components) {
      if (c.texture != scene::kNoTexture) c.texture = scene::TextureId{textures_.place(index(c.texture))};
      if (c.transform != scene::kIdentity) c.transform = scene::TransformId{transforms_.place(index(c.transform))};
      c.kernel = scene::KernelId{static_cast<std::uint16_t>(kernels_.place(index(c.kernel)))};
    }
  }

  Database& database_;
  Column blobs_, solids_, groups_, textures_, transforms_, kernels_;
  std::vector<std::uint32_t> pending_;
};

}  // namespace

void prune(Database& database) { Pruner(database).run(); }

}  // namespace isl::interpreter
