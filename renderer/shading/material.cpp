#include "renderer/shading/material.h"

namespace isl::render {

Material material_of(const scene::Texture& texture, const scene::Colour& ambient_light) {
  const scene::Finish& finish = texture.finish;
  Material material;
  material.pigment = rgb(texture.pigment.colour);
  material.ambient = material.pigment * rgb(finish.ambient) * rgb(ambient_light);
  material.diffuse = material.pigment * finish.diffuse;
  material.brilliance = finish.brilliance;
  material.phong = finish.phong;
  material.phong_size = finish.phong_size;
  material.specular = finish.specular;
  material.specular_exponent = finish.roughness == 0 ? 0 : 1 / finish.roughness;
  return material;
}

MaterialTable::MaterialTable(const scene::Database& database) {
  materials_.reserve(database.textures.size() + 1);
  for (const scene::Texture& texture : database.textures) {
    materials_.push_back(material_of(texture, database.settings.ambient_light));
  }
  materials_.push_back(material_of(database.default_texture, database.settings.ambient_light));
}

}  // namespace isl::render
