#include "renderer/shading/material.h"

namespace isl::render {
namespace {

Material material_of(const scene::Database& database, const scene::Texture& texture) {
  const scene::Pigment& pigment = texture.pigment;
  const scene::Finish& finish = database.finish(texture.finish);
  return {.finish = &finish,
          .pigment = rgb(database.colour(pigment)),
          .ambient = rgb(finish.ambient) * rgb(database.settings.ambient_light),
          .diffuse = finish.diffuse,
          .diffuse_back = finish.diffuse_back,
          .phong = finish.phong,
          .specular = finish.specular,
          .specular_exponent = finish.specular_exponent(),
          .is_patterned = !pigment.is_plain() &&
                          database.pigments[scene::index(pigment.pattern)].pattern.kind != scene::PatternKind::plain};
}

}  // namespace

MaterialTable::MaterialTable(const scene::Database& database) {
  materials_.reserve(database.textures.size() + 1);
  for (const scene::Texture& texture : database.textures) materials_.push_back(material_of(database, texture));
  materials_.push_back(material_of(database, database.default_texture));
}

}  // namespace isl::render
