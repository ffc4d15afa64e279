// Textures made ready for lighting: everything in a texture that does not depend on the point or the light is
// multiplied out once. Colours are in the scene's own working space (Settings::assumed_gamma), in which POV-Ray
// computes; the film makes them linear.
#pragma once

#include "renderer/scene/database.h"

#include <ImathColor.h>

#include <algorithm>
#include <vector>

namespace isl::render {

using Rgb = Imath::Color3<double>;

[[nodiscard]] inline Rgb rgb(const scene::Colour& colour) { return {colour.red, colour.green, colour.blue}; }
[[nodiscard]] inline double largest(const Rgb& colour) { return std::max({colour.x, colour.y, colour.z}); }

/// A texture's finish and, if it is the same everywhere, its pigment.
struct Material {
  const scene::Finish* finish;   ///< the database's; each effect takes its own items from there
  Rgb pigment;                   ///< the plain colour; meaningless if is_patterned
  Rgb ambient;                   ///< finish ambient × ambient_light: a factor of the pigment
  double diffuse, diffuse_back;  ///< shares of light from the front and from behind, at normal incidence
  double phong, specular;        ///< peaks of the highlights
  double specular_exponent;      ///< 1/roughness; 0 for a roughness of 0, as in POV-Ray
  bool is_patterned;             ///< the colour depends on the point
};

/// A texture at a point, with its share of the material there.
struct LitTexture {
  /// It is made where it stays: to copy a record that has just been made takes longer than to make it.
  LitTexture(const Material* material_, const Rgb& pigment_, const Rgb& colour_, double weight_,
             const Rgb& let_through_ = Rgb(1))
      : material(material_), pigment(pigment_), colour(colour_), weight(weight_), let_through(let_through_) {}

  const Material* material;
  Rgb pigment;  ///< the colour at the point times its opacity; the qualities 0 and 1 and the albedo layer show it
  Rgb colour;   ///< the colour alone: metal tints its reflections with it
  double weight;
  Rgb let_through;  ///< light that the layers above let through: a factor of all that the texture shows, highlights
                    ///< included
};

/// The materials of a database, by texture. Immutable; refers to the database.
class MaterialTable {
 public:
  explicit MaterialTable(const scene::Database& database);

  /// kNoTexture gives the scene's default texture.
  [[nodiscard]] const Material& operator[](scene::TextureId id) const {
    return id == scene::kNoTexture ? materials_.back() : materials_[scene::index(id)];
  }

 private:
  std::vector<Material> materials_;  ///< one for each texture, then the default
};

}  // namespace isl::render
