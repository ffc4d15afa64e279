// The model, as observed of POV-Ray 3.7 (tests/renderer/shading keeps the observations):
//   - the normal is turned to the viewer first, so a surface seen from its inside is lit from its inside;
//   - a light with N·L ≤ 0 gives nothing, highlights included;
//   - R is the view mirrored in the surface, and H halfway between the ways to the light and to the eye;
//   - highlights take the light's colour, not the pigment's, and scale with neither diffuse nor brilliance;
//   - a layer shows 1 − filter − transmit of its colour (less than nothing, if these are more than 1) and all of its
//     highlights, and lets through the factor transmit + filter × colour of all that is below;
//   - a `shadowless` light is a fill light: no highlights;
//   - a blob's blended material is the average of its textures' finished colours, not of their parameters. (POV-Ray
//   leaves
//     out shares below its adc_bailout, 1/255, without making up for them; here they count, so that colours have no
//     steps.)
#include "renderer/shading/lighting.h"

#include "renderer/shading/power.h"

namespace isl::render {
namespace {

/// The cosines that highlights depend on; shared by all textures of a point.
struct HighlightAngles {
  double mirror = 0;   ///< R·L
  double halfway = 0;  ///< N·H
};

HighlightAngles highlight_angles(const ShadingPoint& point, const Vec3& to_light) {
  const Vec3 mirrored = point.view - point.normal * (2 * point.normal.dot(point.view));
  const Vec3 halfway = to_light - point.view;
  const double length = halfway.length();
  return {mirrored.dot(to_light), length > 0 ? halfway.dot(point.normal) / length : 0};
}

double highlight(const Material& material, const HighlightAngles& angle) {
  double sum = 0;
  if (material.phong > 0 && angle.mirror > 0) sum += material.phong * power(angle.mirror, material.phong_size);
  if (material.specular > 0 && angle.halfway > 0) {
    sum += material.specular * power(angle.halfway, material.specular_exponent);
  }
  return sum;
}

}  // namespace

Rgb plain_colour(const ShadingPoint& point) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures) colour += lit.pigment * lit.let_through * lit.weight;
  return colour;
}

Rgb ambient_colour(const ShadingPoint& point) {
  Rgb colour(0);
  for (const LitTexture& lit : point.textures) colour += lit.pigment * lit.let_through * lit.material->ambient * lit.weight;
  return colour;
}

LightArrival light_arrival(const ShadingPoint& point, const scene::Light& light, bool highlights) {
  LightArrival arrival;
  const Vec3 way = light.location - point.position;
  arrival.distance = way.length();
  if (!(arrival.distance > 0)) return arrival;
  arrival.direction = way / arrival.distance;
  const double incidence = point.normal.dot(arrival.direction);
  if (!(incidence > 0)) return arrival;
  for (const LitTexture& lit : point.textures) {
    const Material& material = *lit.material;
    arrival.colour +=
        lit.pigment * lit.let_through * (material.diffuse * power(incidence, material.brilliance) * lit.weight);
  }
  if (highlights && !light.shadowless) {
    const HighlightAngles angle = highlight_angles(point, arrival.direction);
    for (const LitTexture& lit : point.textures) {
      arrival.colour += lit.let_through * (highlight(*lit.material, angle) * lit.weight);
    }
  }
  arrival.colour *= rgb(light.colour);
  return arrival;
}

}  // namespace isl::render
