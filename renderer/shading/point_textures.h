// Textures at a point of a surface: what lighting needs of each, its pattern evaluated there.
#pragma once

#include "renderer/patterns/patterns.h"
#include "renderer/shading/material.h"
#include "renderer/tracer.h"

#include <span>
#include <vector>

namespace isl::render {

/// One of a database; immutable, shared by all threads.
class PointTextures {
 public:
  explicit PointTextures(const scene::Database& database)
      : database_(database),
        materials_(database),
        patterns_(database, nullptr, database.settings.number_of_waves),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}

  /// `lit` becomes one entry for each share, in their order.
  void at(std::span<const TextureShare> shares, std::vector<LitTexture>& lit) const;

 private:
  const scene::Database& database_;
  MaterialTable materials_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
};

}  // namespace isl::render
