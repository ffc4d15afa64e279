// Textures at a point of a surface: what lighting needs of each. What a pattern chooses is chosen, layers are laid over
// one another, pigments are evaluated.
#pragma once

#include "renderer/patterns/patterns.h"
#include "renderer/queries/pattern_insides.h"
#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/shading/material.h"
#include "renderer/solids/surface_coordinates.h"

#include <vector>

namespace isl::render {

/// One of a database; immutable, shared by all threads.
class PointTextures {
 public:
  explicit PointTextures(const scene::Database& database)
      : database_(database),
        materials_(database),
        coordinate_textures_(database),
        insides_(database),
        patterns_(database, &insides_, database.settings.number_of_waves),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}
  PointTextures(const PointTextures&) = delete;
  PointTextures& operator=(const PointTextures&) = delete;

  /// Appends what the point's shares are made of: at least one entry each, in their order, the top layer first.
  void append(const SurfacePoint& point, std::vector<LitTexture>& lit) const;

  /// Of a pigment that is on no surface, such as the sky's.
  [[nodiscard]] scene::Colour pigment_colour(const scene::Pigment& pigment, const Vec3& point) const;

  /// (u, v) of a place on a shape; `world` is the same point in the world.
  [[nodiscard]] Coordinates coordinates_of(const SurfacePlace& place, const Vec3& world) const;

 private:
  /// Adds a texture with all that it is made of, at a point of the space that it lives in.
  void add(scene::TextureId id, double weight, const Vec3& point, values::Environment& environment,
           std::vector<LitTexture>& lit) const;
  /// The textures that a pattern chooses there.
  void add_chosen(const scene::TexturePattern& choice, double weight, const Vec3& point,
                  values::Environment& environment, std::vector<LitTexture>& lit) const;
  /// The texture and what lies below it.
  void add_layers(scene::TextureId top, double weight, const Vec3& point, values::Environment& environment,
                  std::vector<LitTexture>& lit) const;

  const scene::Database& database_;
  MaterialTable materials_;
  scene::CoordinateTextures coordinate_textures_;
  PatternInsides insides_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
};

}  // namespace isl::render
