#include "interpreter/prune_textures.h"

#include "interpreter/prune_functions.h"

namespace isl::interpreter {
namespace {

/// The new number of what the id refers to, if it refers to anything.
template <class Id>
void renumber_in(const Column& column, Id& id) {
  if (index(id) != scene::kNone) id = Id{column.place(index(id))};
}

/// Marks a record that refers to nothing more.
template <class Id>
void mark(Column& column, Id id) {
  if (index(id) != scene::kNone) static_cast<void>(column.reach(index(id)));
}

}  // namespace

TexturePruner::TexturePruner(scene::Database& database)
    : database_(database),
      textures_(database.textures.size()),
      finishes_(database.finishes.size()),
      pigments_(database.pigments.size()),
      pigment_maps_(database.pigment_maps.size()),
      normals_(database.normals.size()),
      normal_maps_(database.normal_maps.size()),
      slope_maps_(database.slope_maps.size()),
      texture_patterns_(database.texture_patterns.size()),
      texture_maps_(database.texture_maps.size()),
      images_(database.images.size()),
      interiors_(database.interiors.size()),
      pattern_objects_(database.pattern_objects.size()),
      functions_(database.functions.size()) {}

// ---- Reaching -------------------------------------------------------------------------------------------------------

void TexturePruner::reach(Column& column, Kind kind, std::uint32_t i) {
  if (i != scene::kNone && column.reach(i)) pending_.push_back({kind, i});
}

void TexturePruner::reach(scene::TextureId id) { reach(textures_, Kind::texture, index(id)); }

void TexturePruner::reach(scene::InteriorId id) { mark(interiors_, id); }

void TexturePruner::reach(const scene::Pigment& pigment) { reach(pigments_, Kind::pigment, index(pigment.pattern)); }

void TexturePruner::reach_world(Column& transforms) {
  if (database_.sky_sphere) {
    mark(transforms, database_.sky_sphere->world_from_sky);
    for (const scene::Pigment& pigment : database_.sky_sphere->pigments) reach(pigment);
  }
  for (const scene::Rainbow& rainbow : database_.rainbows)
    reach(pigment_maps_, Kind::pigment_map, index(rainbow.colours));
  if (!database_.camera) return;
  reach(normals_, Kind::normal, index(database_.camera->normal));
  if (database_.camera->blur && database_.camera->blur->bokeh) reach(*database_.camera->blur->bokeh);
}

void TexturePruner::reach(scene::ImageId id) {
  if (id == scene::kNoImage || !images_.reach(index(id))) return;
  reach(functions_, Kind::function, index(database_.images[index(id)].function));
}

void TexturePruner::reach(const scene::Pattern& pattern, Column& transforms,
                          const std::function<void(const scene::Object&)>& reach_object) {
  for (const scene::Warp& warp : pattern.warps) {
    if (const auto* const id = std::get_if<scene::TransformId>(&warp)) mark(transforms, *id);
  }
  if (const auto* const image = std::get_if<scene::ImageId>(&pattern.operands)) reach(*image);
  if (const auto* const function = std::get_if<scene::FunctionOperands>(&pattern.operands)) {
    reach(functions_, Kind::function, index(function->function));
  }
  if (const auto* const pigment = std::get_if<scene::PigmentOperands>(&pattern.operands)) {
    reach(pigments_, Kind::pigment, index(pigment->pigment));
  }
  const auto* const object = std::get_if<scene::ObjectOperands>(&pattern.operands);
  if (object && object->object != scene::kNone && pattern_objects_.reach(object->object)) {
    reach_object(database_.pattern_objects[object->object]);
  }
}

bool TexturePruner::advance(Column& transforms, const std::function<void(const scene::Object&)>& reach_object) {
  if (pending_.empty()) return false;
  const Pending next = pending_.back();
  pending_.pop_back();
  switch (next.kind) {
    case Kind::texture: {
      const scene::Texture& texture = database_.textures[next.record];
      reach(texture.pigment);
      reach(normals_, Kind::normal, index(texture.normal));
      mark(finishes_, texture.finish);
      reach(texture_patterns_, Kind::texture_pattern, index(texture.pattern));
      reach(texture.below);
      break;
    }
    case Kind::texture_pattern: {
      const scene::TexturePattern& record = database_.texture_patterns[next.record];
      reach(record.pattern, transforms, reach_object);
      reach(texture_maps_, Kind::texture_map, index(record.map));
      break;
    }
    case Kind::texture_map:
      for (const scene::TextureEntry& entry : database_.texture_maps[next.record]) reach(entry.texture);
      break;
    case Kind::pigment: {
      const scene::PatternedPigment& pigment = database_.pigments[next.record];
      reach(pigment.pattern, transforms, reach_object);
      reach(pigment_maps_, Kind::pigment_map, index(pigment.map));
      break;
    }
    case Kind::pigment_map:
      for (const scene::PigmentEntry& entry : database_.pigment_maps[next.record]) reach(entry.pigment);
      break;
    case Kind::normal: {
      const scene::Normal& normal = database_.normals[next.record];
      reach(normal.pattern, transforms, reach_object);
      reach(normal_maps_, Kind::normal_map, index(normal.map));
      mark(slope_maps_, normal.slope_map);
      break;
    }
    case Kind::normal_map:
      for (const scene::NormalEntry& entry : database_.normal_maps[next.record])
        reach(normals_, Kind::normal, index(entry.normal));
      break;
    case Kind::function:
      visit_records(database_.functions[next.record],
                    {.pattern = [&](const scene::Pattern& pattern) { reach(pattern, transforms, reach_object); },
                     .pigment = [&](const scene::Pigment& pigment) { reach(pigment); }});
      break;
  }
  return true;
}

// ---- Renumbering ----------------------------------------------------------------------------------------------------

void TexturePruner::renumber(scene::TextureId& id) const { renumber_in(textures_, id); }
void TexturePruner::renumber(scene::InteriorId& id) const { renumber_in(interiors_, id); }
void TexturePruner::renumber(scene::Pigment& pigment) const { renumber_in(pigments_, pigment.pattern); }

void TexturePruner::renumber(scene::Texture& texture) const {
  renumber(texture.pigment);
  renumber_in(normals_, texture.normal);
  renumber_in(finishes_, texture.finish);
  renumber_in(texture_patterns_, texture.pattern);
  renumber(texture.below);
}

void TexturePruner::renumber(scene::Pattern& pattern, const Column& transforms) const {
  for (scene::Warp& warp : pattern.warps) {
    if (auto* const id = std::get_if<scene::TransformId>(&warp)) renumber_in(transforms, *id);
  }
  if (auto* const image = std::get_if<scene::ImageId>(&pattern.operands)) renumber_in(images_, *image);
  if (auto* const function = std::get_if<scene::FunctionOperands>(&pattern.operands))
    renumber_in(functions_, function->function);
  if (auto* const pigment = std::get_if<scene::PigmentOperands>(&pattern.operands))
    renumber_in(pigments_, pigment->pigment);
  auto* const object = std::get_if<scene::ObjectOperands>(&pattern.operands);
  if (object && object->object != scene::kNone) object->object = pattern_objects_.place(object->object);
}

void TexturePruner::compact(const Column& transforms) {
  textures_.compact(database_.textures);
  finishes_.compact(database_.finishes);
  pigments_.compact(database_.pigments);
  pigment_maps_.compact(database_.pigment_maps);
  normals_.compact(database_.normals);
  normal_maps_.compact(database_.normal_maps);
  slope_maps_.compact(database_.slope_maps);
  texture_patterns_.compact(database_.texture_patterns);
  texture_maps_.compact(database_.texture_maps);
  images_.compact(database_.images);
  interiors_.compact(database_.interiors);
  pattern_objects_.compact(database_.pattern_objects);
  functions_.compact(database_.functions);
  for (scene::Texture& texture : database_.textures) renumber(texture);
  for (scene::PatternedPigment& pigment : database_.pigments) {
    renumber(pigment.pattern, transforms);
    renumber_in(pigment_maps_, pigment.map);
  }
  for (scene::PigmentMap& map : database_.pigment_maps) {
    for (scene::PigmentEntry& entry : map) renumber(entry.pigment);
  }
  for (scene::Normal& normal : database_.normals) {
    renumber(normal.pattern, transforms);
    renumber_in(normal_maps_, normal.map);
    renumber_in(slope_maps_, normal.slope_map);
  }
  for (scene::NormalMap& map : database_.normal_maps) {
    for (scene::NormalEntry& entry : map) renumber_in(normals_, entry.normal);
  }
  for (scene::TexturePattern& record : database_.texture_patterns) {
    renumber(record.pattern, transforms);
    renumber_in(texture_maps_, record.map);
  }
  for (scene::TextureMap& map : database_.texture_maps) {
    for (scene::TextureEntry& entry : map) renumber(entry.texture);
  }
  for (scene::Image& image : database_.images) renumber_in(functions_, image.function);
  FunctionRenumberer functions([&](scene::Pattern& pattern) { renumber(pattern, transforms); },
                               [this](scene::Pigment& pigment) { renumber(pigment); });
  for (scene::FunctionPointer& function : database_.functions) function = functions.renumbered(function);
  if (database_.sky_sphere) {
    for (scene::Pigment& pigment : database_.sky_sphere->pigments) renumber(pigment);
    renumber_in(transforms, database_.sky_sphere->world_from_sky);
  }
  for (scene::Rainbow& rainbow : database_.rainbows) renumber_in(pigment_maps_, rainbow.colours);
  if (!database_.camera) return;
  renumber_in(normals_, database_.camera->normal);
  if (database_.camera->blur && database_.camera->blur->bokeh) renumber(*database_.camera->blur->bokeh);
}

}  // namespace isl::interpreter
