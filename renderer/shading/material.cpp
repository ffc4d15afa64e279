#include "renderer/shading/material.h"

#include <cmath>

namespace isl::render {
namespace {

// With `albedo`, an item of a finish gives the share of all light that is reflected into the half-space, instead of the
// peak. These are POV-Ray's factors from the one to the other.

double diffuse_peak(const scene::Finish& finish) { return finish.diffuse_albedo ? (finish.brilliance + 1) / 2 : 1; }

double phong_peak(const scene::Finish& finish) { return finish.phong_albedo ? (finish.phong_size + 1) / 2 : 1; }

double specular_peak(const scene::Finish& finish, double exponent) {
  return finish.specular_albedo ? (exponent + 2) / (4 * (2 - std::exp2(-exponent / 2))) : 1;
}

Material material_of(const scene::Database& database, const scene::Texture& texture) {
  const scene::Pigment& pigment = texture.pigment;
  const scene::Finish& finish = database.finish(texture.finish);
  const double exponent = finish.roughness == 0 ? 0 : 1 / finish.roughness;
  return {.finish = &finish,
          .pigment = rgb(database.colour(pigment)),
          .ambient = rgb(finish.ambient) * rgb(database.settings.ambient_light),
          .diffuse = finish.diffuse * diffuse_peak(finish),
          .diffuse_back = finish.diffuse_back * diffuse_peak(finish),
          .phong = finish.phong * phong_peak(finish),
          .specular = finish.specular * specular_peak(finish, exponent),
          .specular_exponent = exponent,
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
