// What is reached of the columns that textures, interiors, functions and the atmosphere are made of. Knows nothing of
// shapes.
#pragma once

#include "interpreter/prune_column.h"
#include "renderer/scene/database.h"

#include <functional>
#include <vector>

namespace isl::interpreter {

class TexturePruner {
 public:
  explicit TexturePruner(scene::Database& database);

  // Each marks the record, if the number is one, and puts what it refers to on the list.
  void reach(scene::TextureId id);
  void reach(scene::InteriorId id);
  /// What sky, rainbows and the camera refer to.
  void reach_world(Column& transforms);

  /// Looks at one record of the list; false when it is empty. Transforms are marked in `transforms`, the objects of
  /// patterns are handed to `reach_object`.
  [[nodiscard]] bool advance(Column& transforms, const std::function<void(const scene::Object&)>& reach_object);

  /// Keeps what is reached and renumbers what refers to it, transforms included. The columns of `transforms` and of
  /// shapes are compacted by whoever has them.
  void compact(const Column& transforms);
  void renumber(scene::TextureId& id) const;
  void renumber(scene::InteriorId& id) const;

 private:
  enum class Kind : std::uint8_t {
    texture,
    texture_pattern,
    texture_map,
    pigment,
    pigment_map,
    normal,
    normal_map,
    function
  };
  struct Pending {
    Kind kind;
    std::uint32_t record;
  };

  void reach(Column& column, Kind kind, std::uint32_t i);
  void reach(const scene::Pigment& pigment);
  void reach(scene::ImageId id);
  void reach(const scene::Pattern& pattern, Column& transforms,
             const std::function<void(const scene::Object&)>& reach_object);
  void renumber(scene::Pigment& pigment) const;
  void renumber(scene::Texture& texture) const;
  void renumber(scene::Pattern& pattern, const Column& transforms) const;

  scene::Database& database_;
  Column textures_, finishes_, pigments_, pigment_maps_, normals_, normal_maps_, slope_maps_, texture_patterns_,
      texture_maps_, images_, interiors_, pattern_objects_, functions_;
  std::vector<Pending> pending_;
};

}  // namespace isl::interpreter
