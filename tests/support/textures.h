// Plain textures for databases that tests make without the language.
#pragma once

#include "renderer/scene/database.h"

namespace isl::test {

/// A texture of one colour whose finish is a record of the database.
[[nodiscard]] inline scene::Texture plain_texture(scene::Database& database, const scene::Colour& colour,
                                                  const scene::Finish& finish) {
  database.finishes.push_back(finish);
  scene::Texture texture;
  texture.pigment.colour = colour;
  texture.finish = scene::FinishId{static_cast<std::uint32_t>(database.finishes.size() - 1)};
  return texture;
}

}  // namespace isl::test
