#include "renderer/shading/material.h"

namespace isl::render {

Material material_of(const scene::Texture& texture, const scene::Finish& finish, const scene::Colour& ambient_light) {
  Material material;
  material.pigment = rgb(texture.pigment.colour);
  material.ambient = rgb(finish.ambient) * rgb(ambient_light);
  material.diffuse = finish.diffuse;
  material.brilliance = finish.brilliance;
  material.phong = finish.phong;
  material.phong_size = finish.phong_size;
  material.specular = finish.specular;
  material.specular_exponent = finish.roughness == 0 ? 0 : 1 / finish.roughness;
  material.metallic = finish.metallic;
  const scene::Reflection& reflection = finish.reflection;
  material.mirror = {scene::reflects(finish), rgb(reflection.minimum), rgb(reflection.maximum), reflection.falloff,
                     reflection.metallic};
  return material;
}

MaterialTable::MaterialTable(const scene::Database& database) {
  materials_.reserve(database.textures.size() + 1);
  const auto add = [&](scene::Texture texture) {
    const bool is_patterned =
        !texture.pigment.is_plain() &&
        database.pigments[scene::index(texture.pigment.pattern)].pattern.kind != scene::PatternKind::plain;
    texture.pigment = {database.colour(texture.pigment)};
    materials_.push_back(material_of(texture, database.finish(texture.finish), database.settings.ambient_light));
    materials_.back().is_patterned = is_patterned;
  };
  for (const scene::Texture& texture : database.textures) add(texture);
  add(database.default_texture);
}

}  // namespace isl::render
