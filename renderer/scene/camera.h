// The camera: its place, its projection and its lens.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/pigment.h"
#include "renderer/scene/said_at.h"
#include "renderer/scene/transform.h"

#include <array>
#include <cstdint>
#include <optional>

namespace isl::scene {

enum class CameraKind : std::uint8_t {
  perspective,
  orthographic,
  fisheye,
  ultra_wide_angle,
  omnimax,
  panoramic,
  cylinder,
  spherical,
  user_defined,
};

/// Depth of field: a lens in whose picture only one distance is sharp.
struct FocalBlur {
  double aperture = 0;                   ///< diameter of the lens; above 0
  double focal_distance = 0;             ///< from the location to the plane, or the sphere, in focus
  int min_samples = 0, max_samples = 0;  ///< rays a pixel
  double confidence = 0.9;               ///< probability that the error of a pixel's value …
  double variance = 1.0 / 128;           ///< … is within this variance; ranges: ]0, 1[ and [0, 1]
  std::optional<Pigment> bokeh{};        ///< brightness over the lens, x and y from 0 to 1; nullopt: a uniform disc
};

/// The coordinates of a point or vector as functions of the image coordinates (u, v, 0); none, or all three.
using VectorFunctions = std::array<FunctionId, 3>;
inline constexpr VectorFunctions kNoVectorFunctions{kNoFunction, kNoFunction, kNoFunction};

/// Items whose places are kept.
enum class CameraItem : std::uint8_t { kind, blur, normal, count };

/// A camera after look_at, angle and sky have been applied. perspective: the ray through image coordinates (u, v), u
/// and v from −½ to ½, right and up, goes along direction + u·right + v·up. orthographic: it starts at location +
/// u·right + v·up and goes along direction. The other kinds bend rays by their angles and take the three vectors as
/// axes. The vectors carry their lengths. user_defined: the rays start at location and go along direction, each the
/// value of its functions if it has any.
struct Camera {
  Vec3 location{0, 0, 0};
  Vec3 direction{0, 0, 1};
  Vec3 right{4.0 / 3.0, 0, 0};
  Vec3 up{0, 1, 0};
  CameraKind kind = CameraKind::perspective;
  int cylinder_type = 0;  ///< kind `cylinder`: 1 to 4, axis upright or lying, rays from a point or a line
  double angle = 0;  ///< radians across the picture; 0 where the kind has none (perspective, orthographic, omnimax)
  double vertical_angle = 0;  ///< of a spherical camera, radians
  VectorFunctions location_of = kNoVectorFunctions, direction_of = kNoVectorFunctions;  ///< kind `user_defined`
  std::optional<FocalBlur> blur{};
  NormalId normal = kNoNormal;  ///< perturbs the rays by its bumps at the image point (u, v)
  SaidAt<CameraItem> said_at{};
  OriginId origin{};
};

}  // namespace isl::scene
