// POV-Ray 3.7's lighting of a surface point: what it shows by itself, and what one light adds where nothing is in
// between. Does not ask whether anything is: that is effects/shadows.
#pragma once

#include "renderer/shading/material.h"

#include <span>

namespace isl::render {

using scene::Vec3;

/// A point about to be lit, in world space.
struct ShadingPoint {
  Vec3 position;
  Vec3 normal;                             ///< unit, turned to the viewer
  Vec3 view;                               ///< unit, from the eye to the point
  std::span<const LitTexture> textures;  ///< shares that add up to one
};

/// `normal` or its opposite, whichever faces the eye that looks along `view`. Across the view it is left alone.
[[nodiscard]] inline Vec3 turned_to_viewer(const Vec3& normal, const Vec3& view) {
  return normal.dot(view) > 0 ? -normal : normal;
}

/// What a light adds, and the way to it.
struct LightArrival {
  Rgb colour{0};        ///< zero when the light is behind the surface, or at the point itself
  Vec3 direction{0};    ///< unit, from the point to the light
  double distance = 0;  ///< to the light, in scene units

  [[nodiscard]] bool is_dark() const { return colour.x == 0 && colour.y == 0 && colour.z == 0; }
};

// In these a share is the texture's weight times what the layers above it let through.

/// Σ share × pigment: the point without light.
[[nodiscard]] Rgb plain_colour(const ShadingPoint& point);

/// Σ share × ambient × ambient_light × pigment.
[[nodiscard]] Rgb ambient_colour(const ShadingPoint& point);

/// Σ share × light colour × (diffuse (N·L)^brilliance pigment + phong (R·L)^phong_size + specular (N·H)^(1/roughness)),
/// all zero unless N·L > 0; a shadowless light gives no highlights. `highlights` false: the caller knows that there are
/// none.
[[nodiscard]] LightArrival light_arrival(const ShadingPoint& point, const scene::Light& light, bool highlights);

}  // namespace isl::render
