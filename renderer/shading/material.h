// Textures made ready for lighting: everything about one that does not depend on the point or the light is multiplied
// out once. Colours are in the scene's own working space (Settings::assumed_gamma), as POV-Ray computes; film makes
// them linear.
#pragma once

#include "renderer/scene/database.h"

#include <ImathColor.h>

#include <vector>

namespace isl::render {

using Rgb = Imath::Color3<double>;

[[nodiscard]] inline Rgb rgb(const scene::Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// What a surface mirrors: from `minimum` seen head-on to `maximum` at grazing angles.
struct Mirror {
  bool reflects = false;
  Rgb minimum{0}, maximum{0};
  double falloff = 1;   ///< of the way from one to the other
  double metallic = 0;  ///< how far it takes the pigment's colour
};

/// A texture's finish and, where it is the same everywhere, its pigment. Highlights take the light's colour, and that of the pigment
/// as far as the finish is metallic.
struct Material {
  Rgb pigment;  ///< the plain colour; says nothing where is_patterned
  Rgb ambient;  ///< finish ambient × ambient_light: the pigment's factor
  double diffuse = 0;
  bool is_patterned = false;  ///< the colour depends on the point
  double brilliance = 1;
  double phong = 0;
  double phong_size = 40;
  double specular = 0;
  double specular_exponent = 20;  ///< 1/roughness; 0 for a roughness of 0, as POV-Ray has it
  double metallic = 0;
  Mirror mirror;

  [[nodiscard]] bool has_highlight() const { return phong > 0 || specular > 0; }
};

/// A texture at a point, with its share of the material there.
struct LitTexture {
  const Material* material;
  Rgb pigment;  ///< the colour at the point times how opaque it is; what quality 0 and 1 show, and the albedo layer
  Rgb colour;   ///< the colour alone: what metal mirrors in
  double weight;
  Rgb let_through{1};  ///< by the layers above: a factor for all that the texture shows, highlights included
};

[[nodiscard]] Material material_of(const scene::Texture& texture, const scene::Finish& finish,
                                   const scene::Colour& ambient_light);

/// The materials of a database, by texture. Immutable.
class MaterialTable {
 public:
  explicit MaterialTable(const scene::Database& database);

  /// kNoTexture gives the scene's default texture.
  [[nodiscard]] const Material& operator[](scene::TextureId id) const {
    return id == scene::kNoTexture ? materials_.back() : materials_[scene::index(id)];
  }

 private:
  std::vector<Material> materials_;  ///< one a texture, then the default
};

}  // namespace isl::render
