// How much light surfaces mirror.
#pragma once

#include "renderer/numerics/power.h"
#include "renderer/shading/material.h"
#include "renderer/shading/metal.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

/// The greatest reflectivity at any angle, as POV-Ray estimates it.
[[nodiscard]] inline double largest_reflectivity(const scene::Finish& finish) {
  return std::max(largest(rgb(finish.reflection.minimum)), largest(rgb(finish.reflection.maximum)));
}

/// The share of unpolarised light that a surface between two media mirrors, by Fresnel; `ratio` is the index of
/// refraction before the surface over that behind it.
[[nodiscard]] inline double fresnel_share(double cosine, double ratio) {
  const double squared = 1 / (ratio * ratio) + cosine * cosine - 1;
  if (!(squared > 0)) return 1;
  const double g = std::sqrt(squared), c = cosine;
  const double across = (g - c) / (g + c), along = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * across * across * (1 + along * along);
}

/// True if some finish has `fresnel` of its own, besides that of its reflection.
[[nodiscard]] inline bool any_fresnel(const scene::Database& database) {
  return std::ranges::any_of(database.finishes, [](const scene::Finish& finish) { return finish.fresnel != 0; });
}

/// The share of a finish's `fresnel` that its surface mirrors of light that falls in at this cosine to the normal. As
/// in POV-Ray, all of light from behind is lost.
[[nodiscard]] inline double mirrored_by(const scene::Finish& finish, double cosine, double ratio) {
  return finish.fresnel * (cosine > 0 ? fresnel_share(std::min(cosine, 1.0), ratio) : 1);
}

/// The reflectivity minimum + (maximum − minimum)(1 − c)^falloff, or Fresnel's share instead of the power, where c is
/// the cosine of the view to the normal, below 0 where bumps turn it away; `colour` is the pigment's, which tints
/// metal, and `ratio` that of fresnel_share.
[[nodiscard]] inline Rgb reflectivity_at(const scene::Finish& finish, double cosine, double ratio, const Rgb& colour) {
  const scene::Reflection& mirror = finish.reflection;
  const Rgb minimum = rgb(mirror.minimum), maximum = rgb(mirror.maximum);
  Rgb share = minimum;
  if (finish.fresnel_reflection) {
    share += (maximum - minimum) * fresnel_share(std::clamp(cosine, 0.0, 1.0), ratio);
  } else if (maximum != minimum) {
    const double away = std::max(1 - cosine, 0.0);
    const double grazing = mirror.falloff == 1 ? away : power(away, mirror.falloff);
    share += (maximum - minimum) * grazing;
  }
  if (mirror.metallic != 0) share *= metal_tint(mirror.metallic, cosine, colour);
  return share;
}

}  // namespace isl::render
