// POV-Ray 3.7's lighting of a surface point, term by term: the point's own light, and the light that one light source
// adds if nothing is in between. A scene's effects decide which terms it has. All of it runs once for each point and
// light, so it is inline.
//
// The model, as observed of POV-Ray 3.7 (tests/renderer/shading keeps the observations):
//   - The normal is turned to the viewer first, so a surface seen from its inside is lit from its inside.
//   - A light with N·L ≤ 0 gives nothing, highlights included.
//   - R is the view mirrored in the surface, and H is halfway between the ways to the light and to the eye.
//   - Highlights take the light's colour, and the pigment's on metal. They scale with neither diffuse nor brilliance.
//   - A layer shows 1 − filter − transmit of its colour (a negative share, if these are more than 1) and all of its
//     highlights, and lets through the factor transmit + filter × colour of everything below.
//   - A `shadowless` light is a fill light: it makes no highlights.
//   - A blob's blended material is the average of its textures' finished colours, not of their parameters. POV-Ray
//     leaves out shares below its adc_bailout, 1/255, without making up for them; here they count, so that colours have
//     no steps.
#pragma once

#include "renderer/numerics/power.h"
#include "renderer/shading/material.h"

#include <span>

namespace isl::render {

using scene::Vec3;

/// A point to be lit, in world space.
struct ShadingPoint {
  Vec3 position;
  Vec3 normal;                           ///< unit, turned to the viewer
  Vec3 view;                             ///< unit, from the eye to the point
  std::span<const LitTexture> textures;  ///< shares that add up to one
};

/// `normal` or its opposite, whichever faces the eye that looks along `view`. It is left alone if it is perpendicular
/// to the view.
[[nodiscard]] inline Vec3 turned_to_viewer(const Vec3& normal, const Vec3& view) {
  return normal.dot(view) > 0 ? -normal : normal;
}

/// The direction and distance from a point to a light. The distance is 0 at the light itself, which then lights
/// nothing.
struct LightSample {
  Vec3 direction{0};  ///< unit, from the point to the light
  double distance = 0;
};

/// The only sampler of lights: both pictures and measurements of shadow rays use it.
[[nodiscard]] inline LightSample sample_light(const scene::Light& light, const Vec3& position) {
  const Vec3 way = light.location - position;
  const double distance = way.length();
  if (!(distance > 0)) return {};
  return {way / distance, distance};
}

// In the following sums, a share is the texture's weight times the light that the layers above it let through.

/// Σ share × pigment: the point without light.
[[nodiscard]] inline Rgb plain_colour(const ShadingPoint& point) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures) colour += lit.pigment * lit.let_through * lit.weight;
  return colour;
}

/// Σ share × ambient × ambient_light × pigment.
[[nodiscard]] inline Rgb ambient_colour(const ShadingPoint& point) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures)
    colour += lit.pigment * lit.let_through * lit.material->ambient * lit.weight;
  return colour;
}

/// Σ share × diffuse (N·L)^brilliance × pigment, for N·L = incidence above 0.
[[nodiscard]] inline Rgb diffuse_colour(const ShadingPoint& point, double incidence) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures) {
    const scene::Finish& finish = *lit.material->finish;
    colour += lit.pigment * lit.let_through * (finish.diffuse * power(incidence, finish.brilliance) * lit.weight);
  }
  return colour;
}

/// The cosines that highlights depend on. All textures of a point share them.
struct HighlightAngles {
  double mirror = 0;   ///< R·L
  double halfway = 0;  ///< N·H
};

[[nodiscard]] inline HighlightAngles highlight_angles(const ShadingPoint& point, const Vec3& to_light) {
  const Vec3 mirrored = point.view - point.normal * (2 * point.normal.dot(point.view));
  const Vec3 halfway = to_light - point.view;
  const double length = halfway.length();
  return {mirrored.dot(to_light), length > 0 ? halfway.dot(point.normal) / length : 0};
}

/// phong (R·L)^phong_size + specular (N·H)^(1/roughness), where a term counts only if its cosine is above 0.
[[nodiscard]] inline double highlight(const Material& material, const HighlightAngles& angle) {
  const scene::Finish& finish = *material.finish;
  double sum = 0;
  if (finish.phong > 0 && angle.mirror > 0) sum += finish.phong * power(angle.mirror, finish.phong_size);
  if (finish.specular > 0 && angle.halfway > 0) {
    sum += finish.specular * power(angle.halfway, material.specular_exponent);
  }
  return sum;
}

}  // namespace isl::render
