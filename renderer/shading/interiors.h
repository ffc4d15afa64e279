// The media inside bodies, as light meets them: refraction at their surfaces, and what is left of it on the way out.
#pragma once

#include "renderer/numerics/power.h"
#include "renderer/scene/database.h"
#include "renderer/shading/material.h"
#include "renderer/shading/spectrum.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace isl::render {

using scene::Vec3;

struct Medium {
  double ior = 1;
  double caustics = 0;
  double fade_distance = 0, fade_power = 0;
  Rgb fade_colour{0};
  double dispersion = 1;  ///< the index for violet over that for red
  int colours = 1;        ///< into which white light is parted

  [[nodiscard]] double ior_of(const Wave& wave) const {
    return wave.is_white() || dispersion == 1 ? ior : ior * power(dispersion, wave.bend());
  }

  /// The share of light that is left after a way through the medium: all of it at 0, and half of what fades at
  /// fade_distance; with a power of 1000 or more it fades exponentially. As in POV-Ray.
  [[nodiscard]] Rgb left_after(double way) const {
    if (!(fade_distance > 0)) return Rgb(1);
    constexpr double kExponential = 1000;
    const Rgb fading = Rgb(1) - fade_colour;
    if (fade_power < kExponential) return fade_colour + fading / (1 + std::pow(way / fade_distance, fade_power));
    const Rgb depth = fading * (way / fade_distance);
    return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
  }
};

/// The media of all interiors of a database.
class Interiors {
 public:
  explicit Interiors(const scene::Database& database) {
    for (const scene::Interior& interior : database.interiors) {
      media_.push_back({interior.ior == 0 ? 1 : interior.ior, interior.caustics, interior.fade_distance,
                        interior.fade_power, rgb(interior.fade_colour), interior.dispersion,
                        static_cast<int>(interior.dispersion_samples)});
    }
  }
  [[nodiscard]] const Medium& operator[](scene::InteriorId id) const {
    return id == scene::kNoInterior ? none_ : media_[scene::index(id)];
  }

 private:
  std::vector<Medium> media_;
  Medium none_;
};

/// The direction behind a surface with the normal n (of either sign), if `ratio` is the index of refraction before it
/// over that behind it; nothing if all light is reflected.
[[nodiscard]] inline std::optional<Vec3> refracted(const Vec3& direction, Vec3 n, double ratio) {
  if (ratio == 1) return direction;
  double cosine = -n.dot(direction);
  if (cosine < 0) {
    n = -n;
    cosine = -cosine;
  }
  const double rest = 1 - ratio * ratio * (1 - cosine * cosine);
  if (rest < 0) return std::nullopt;
  return (direction * ratio + n * (ratio * cosine - std::sqrt(rest))).normalized();
}

/// The direction mirrored in a bent normal n. A mirror image behind the surface itself, whose normal is `flat`, is
/// brought in front of it as in POV-Ray.
[[nodiscard]] inline Vec3 mirrored(const Vec3& direction, const Vec3& n, const Vec3& flat) {
  const auto in = [](const Vec3& v, const Vec3& normal) { return v - normal * (2 * normal.dot(v)); };
  Vec3 result = in(direction, n);
  if (result.dot(flat) < 0) result = in(result.dot(n) < 0 ? direction : result, flat);
  return result.normalized();
}

}  // namespace isl::render
