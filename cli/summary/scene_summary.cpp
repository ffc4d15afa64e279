#include "cli/summary/scene_summary.h"

#include "renderer/scene/group_walk.h"

#include <optional>
#include <span>
#include <vector>

namespace isl::cli {
namespace {

using scene::Database;
using scene::Object;

/// Groups share groups, so a short scene may place more objects than a program can visit: each group is counted once.
class Counter {
 public:
  explicit Counter(const Database& database) : database_(database), groups_(database.groups.size()) {}

  SceneSummary of(std::span<const Object> objects) {
    for (const Object& object : objects) {
      if (object.kind == Object::Kind::group) count(object.shape);
    }
    return sum_of(objects);
  }

 private:
  /// The groups among the objects are counted.
  SceneSummary sum_of(std::span<const Object> objects) const {
    SceneSummary sum;
    for (const Object& object : objects) {
      switch (object.kind) {
        case Object::Kind::solid: ++sum.solids; break;
        case Object::Kind::blob:
          ++sum.blobs;
          sum.fields += database_.blobs[object.shape].components.size();
          break;
        case Object::Kind::group: {
          const SceneSummary& inner = *groups_[object.shape];
          sum.fields += inner.fields;
          sum.blobs += inner.blobs;
          sum.solids += inner.solids;
          sum.lights += inner.lights;
          break;
        }
      }
    }
    return sum;
  }

  void count(std::uint32_t group) {
    scene::finish_groups(
        database_, group, [this](std::uint32_t i) { return groups_[i].has_value(); },
        [this](std::uint32_t i) {
          groups_[i] = sum_of(database_.groups[i].children);
          groups_[i]->lights += database_.groups[i].lights.size();
        });
  }

  const Database& database_;
  std::vector<std::optional<SceneSummary>> groups_;
};

template <class Column>
std::size_t bytes(const Column& column) {
  return column.capacity() * sizeof(typename Column::value_type);
}

}  // namespace

SceneSummary summarise(const Database& database) {
  SceneSummary summary = Counter(database).of(database.objects);
  summary.lights += database.lights.size();
  summary.textures = database.textures.size();
  return summary;
}

std::size_t database_bytes(const Database& database) {
  std::size_t sum = bytes(database.kernels) + bytes(database.transforms) + bytes(database.textures) +
                    bytes(database.blobs) + bytes(database.solids) + bytes(database.polynomials) +
                    bytes(database.triangles) + bytes(database.polygons) + bytes(database.outlines) +
                    bytes(database.groups) + bytes(database.objects) + bytes(database.lights);
  for (const scene::Blob& blob : database.blobs)
    sum += bytes(blob.components) + bytes(blob.origins) + bytes(blob.corners);
  for (const scene::Group& group : database.groups) sum += bytes(group.children) + bytes(group.lights);
  for (const scene::Polynomial& polynomial : database.polynomials) sum += bytes(polynomial.coefficients);
  for (const scene::Polygon& polygon : database.polygons) sum += bytes(polygon.points);
  for (const scene::Outline& outline : database.outlines)
    sum += bytes(outline.points) + bytes(outline.orders) + bytes(outline.contours);
  return sum;
}

}  // namespace isl::cli
