// POV-Ray 3.7's lighting of a surface point, term by term: the point's own light, and the light that one light source
// adds if nothing is in between. A scene's effects decide which terms it has. All of it runs once for each point and
// light, so it is inline.
//
// The model, as observed of POV-Ray 3.7 (tests/renderer/shading keeps the observations):
//   - The normal is turned to the viewer first, so a surface seen from its inside is lit from its inside.
//   - A light with N·L ≤ 0 gives nothing, highlights included, unless the finish has a second `diffuse`, for light from
//     behind, or the object says `double_illuminate`: then N·L counts without its sign.
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
#include "renderer/rays/surface_point.h"
#include "renderer/shading/material.h"

#include <cmath>
#include <limits>
#include <span>

namespace isl::render {

using scene::Vec3;

/// A point to be lit, in world space.
struct ShadingPoint {
  /// It is made where it stays, as LitTexture is.
  ShadingPoint(const Vec3& position_, const Vec3& normal_, const Vec3& view_,
               std::span<const LitTexture> textures_ = {}, bool is_lit_from_both_sides_ = false,
               bool from_inside_ = false, bool is_hollow_ = false, double ior_ratio_ = 1,
               scene::InteriorId interior_ = scene::kNoInterior, BodyId body_ = {})
      : position(position_),
        normal(normal_),
        view(view_),
        textures(textures_),
        is_lit_from_both_sides(is_lit_from_both_sides_),
        from_inside(from_inside_),
        is_hollow(is_hollow_),
        ior_ratio(ior_ratio_),
        interior(interior_),
        body(body_) {}

  Vec3 position;
  Vec3 normal;                           ///< unit, turned to the viewer
  Vec3 view;                             ///< unit, from the eye to the point
  std::span<const LitTexture> textures;  ///< shares that add up to one
  bool is_lit_from_both_sides;           ///< `double_illuminate`
  bool from_inside;                      ///< the path comes from within the body
  bool is_hollow;                        ///< of the object
  double ior_ratio;  ///< the index of refraction before the surface over that behind it; known if there is `fresnel`
  scene::InteriorId interior;  ///< the medium on the inner side
  BodyId body;                 ///< what the surface bounds
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
  double strength = 1;  ///< the share of the light's colour that comes this way, if nothing is in between
};

/// The light's axis, from its location to point_at; unit.
[[nodiscard]] inline Vec3 axis_of(const scene::Light& light) { return (light.point_at - light.location).normalized(); }

/// True if the light's rays run along its axis. The beam of a `cylinder` does.
[[nodiscard]] inline bool is_parallel(const scene::Light& light) {
  return light.parallel || light.kind == scene::LightKind::cylinder;
}

/// The distance of light that comes from no place in particular: no surface is nearer.
inline constexpr double kNothingBetween = std::numeric_limits<double>::denorm_min();

/// Light from a point of a light source. Parallel light runs from that point towards point_at everywhere. It comes from
/// the plane through the point; what lies before that plane has it too, as in POV-Ray, and nothing can be in between.
/// The beam of a `cylinder` begins at the plane.
[[nodiscard, gnu::always_inline]] inline LightSample sample_light_from(const scene::Light& light, const Vec3& source,
                                                                       const Vec3& position) {
  if (is_parallel(light)) [[unlikely]] {
    const Vec3 axis = (light.point_at - source).normalized();
    const double distance = (position - source).dot(axis);
    if (distance > 0) return {-axis, distance};
    return light.kind == scene::LightKind::cylinder ? LightSample{} : LightSample{-axis, kNothingBetween};
  }
  const Vec3 way = source - position;
  const double distance = way.length();
  if (!(distance > 0)) return {};
  return {way / distance, distance};
}

/// The only sampler of lights: both pictures and measurements of shadow rays use it.
[[nodiscard]] inline LightSample sample_light(const scene::Light& light, const Vec3& position) {
  return sample_light_from(light, light.location, position);
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

/// cosine^brilliance; most finishes have a brilliance of 1.
[[nodiscard]] inline double brightened(double cosine, double brilliance) {
  return brilliance == 1 ? cosine : power(cosine, brilliance);
}

/// Σ share × diffuse (N·L)^brilliance × pigment, for N·L = incidence above 0.
[[nodiscard]] inline Rgb diffuse_colour(const ShadingPoint& point, double incidence) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures) {
    const double share = lit.material->diffuse * brightened(incidence, lit.material->finish->brilliance);
    colour += lit.pigment * lit.let_through * (share * lit.weight);
  }
  return colour;
}

/// The share of light that a texture throws back if it falls in at this cosine: below 0, from behind.
[[nodiscard]] inline double diffuse_share(const Material& material, double cosine) {
  if (cosine == 0) return 0;
  return (cosine > 0 ? material.diffuse : material.diffuse_back) *
         brightened(std::abs(cosine), material.finish->brilliance);
}

}  // namespace isl::render
