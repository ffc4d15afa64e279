// The rows of what cannot be drawn yet of a surface's looks. Internal to renderer/scene.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/scene/unrendered_features.h"

#include <span>
#include <string_view>

namespace isl::scene {

/// A texture refers to other columns, so both ask for the database.
struct TextureFeature {
  std::string_view what;
  bool (*is_used)(const Database&, const Texture&);
  void (*leave_out)(const Database&, Texture&);
};

/// Of a texture apart from its finish; in the order in which they are left out.
[[nodiscard]] std::span<const TextureFeature> texture_features();
[[nodiscard]] std::span<const Feature<Finish>> finish_features();

}  // namespace isl::scene
