// Textures at a point of a surface: what lighting needs of each, its pattern evaluated there.
#pragma once

#include "renderer/patterns/patterns.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/shading/material.h"
#include "renderer/surface_coordinates.h"
#include "renderer/tracer.h"

#include <vector>

namespace isl::render {

/// One of a database; immutable, shared by all threads.
class PointTextures {
 public:
  explicit PointTextures(const scene::Database& database)
      : database_(database),
        materials_(database),
        coordinate_textures_(database),
        patterns_(database, nullptr, database.settings.number_of_waves),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}

  /// `lit` becomes one entry for each of the point's shares, in their order.
  void at(const SurfacePoint& point, std::vector<LitTexture>& lit) const;

  /// (u, v) of a place on a shape; `world` is the same point in the world.
  [[nodiscard]] Coordinates coordinates_of(const SurfacePlace& place, const Vec3& world) const;

 private:
  const scene::Database& database_;
  MaterialTable materials_;
  scene::CoordinateTextures coordinate_textures_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
};

}  // namespace isl::render
