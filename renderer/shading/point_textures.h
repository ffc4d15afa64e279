// The textures at a point of a surface, as lighting needs them: patterns choose among textures, layers are laid over
// one another, and pigments are evaluated.
#pragma once

#include "base/run_limits.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/pattern_insides.h"
#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/shading/material.h"
#include "renderer/solids/surface_coordinates.h"

#include <optional>
#include <vector>

namespace isl::render {

/// Serves one database; immutable, shared by all threads.
class PointTextures {
 public:
  /// `run` limits the steps at each point.
  explicit PointTextures(const scene::Database& database, const RunLimits& run = {})
      : database_(database),
        run_(run),
        materials_(database),
        coordinate_textures_(database),
        insides_(database),
        patterns_(database, &insides_, database.settings.number_of_waves),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}
  PointTextures(const PointTextures&) = delete;
  PointTextures& operator=(const PointTextures&) = delete;

  /// Appends the textures that the point's shares consist of: at least one entry for each, in their order, the top
  /// layer first. `charge` counts the memory that `lit` grows by. False, with nothing appended, if that or the steps of
  /// the run did not suffice, or the run is stopped.
  [[nodiscard]] bool append(const SurfacePoint& point, std::vector<LitTexture>& lit, Charge& charge) const;

  /// The colour of a pigment that is on no surface, such as the sky's. Nullopt if the steps of the run did not suffice,
  /// or the run is stopped.
  [[nodiscard]] std::optional<scene::Colour> pigment_colour(const scene::Pigment& pigment, const Vec3& point) const;

  /// (u, v) of a place on a shape; `world` is the same point in the world.
  [[nodiscard]] Coordinates coordinates_of(const SurfacePlace& place, const Vec3& world) const;

 private:
  /// The textures of one point in the making.
  struct Making;
  /// Adds a texture with all its parts, at a point of the space that it lives in.
  void add(scene::TextureId id, double weight, const Vec3& point, Making& making) const;
  /// Adds the textures that a pattern chooses at the point.
  void add_chosen(const scene::TexturePattern& choice, double weight, const Vec3& point, Making& making) const;
  /// Adds the texture and the layers below it.
  void add_layers(scene::TextureId top, double weight, const Vec3& point, Making& making) const;

  const scene::Database& database_;
  RunLimits run_;
  MaterialTable materials_;
  scene::CoordinateTextures coordinate_textures_;
  PatternInsides insides_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
};

}  // namespace isl::render
