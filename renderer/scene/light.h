// Light sources.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/colour.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/said_at.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <optional>

namespace isl::scene {

/// point: light in all directions. spotlight: a cone about the axis from location to point_at. cylinder: a beam about
/// it.
enum class LightKind : std::uint8_t { point, spotlight, cylinder };

/// A light of many points: a grid spanned by two edges, centred at the light's location.
struct AreaLight {
  Vec3 edge_a{0}, edge_b{0};     ///< whole lengths of the grid's sides
  int count_a = 1, count_b = 1;  ///< number of points along each
  int adaptive = kNotAdaptive;   ///< subdivision begins at 2^adaptive + 1 points a side
  bool jitter = false;
  bool circular = false;           ///< the grid is pressed into an ellipse
  bool orient = false;             ///< turned to face each point that it lights
  bool area_illumination = false;  ///< diffuse and specular light come from every point, not from the centre

  static constexpr int kNotAdaptive = -1;  ///< all points are sampled
};

/// Items whose places are kept.
enum class LightItem : std::uint8_t { kind, parallel, area, jitter, fade, projected_through, count };

struct Light {
  Vec3 location{0};
  Colour colour{1, 1, 1};
  bool shadowless = false;
  LightKind kind = LightKind::point;
  bool parallel = false;  ///< rays run along the axis from location to point_at
  Vec3 point_at{0, 0, 1};
  /// The light is full within `radius` and none from `falloff` on. Both are angles to the axis for a spotlight, and
  /// distances from it for a cylinder.
  double radius = 0, falloff = 0;
  double tightness = 0;  ///< exponent of the further fall with the angle or distance
  /// If both are above 0, the light at distance d is divided by (1 + (d/fade_distance)^fade_power)/2.
  double fade_distance = 0, fade_power = 0;
  bool fades_from_point = false;  ///< instead, it is divided by d^fade_power: POV-Ray 3.8, without a fade_distance
  std::optional<AreaLight> area{};
  bool media_interaction = true;
  bool media_attenuation = false;
  GroupId projected_through = kNoGroup;  ///< the light shines only through this group, given in the light's own space …
  Transform world_from_projected{};      ///< … whose transform follows the light
  SaidAt<LightItem> said_at{};
  OriginId origin{};
};

/// Transforms a light. Radius and falloff do not change, as in POV-Ray.
inline void move(Light& light, const Transform& transform) {
  light.location = transform.point(light.location);
  light.point_at = transform.point(light.point_at);
  if (light.area) {
    light.area->edge_a = transform.vector(light.area->edge_a);
    light.area->edge_b = transform.vector(light.area->edge_b);
  }
  if (light.projected_through != kNoGroup) light.world_from_projected = then(light.world_from_projected, transform);
}

}  // namespace isl::scene
