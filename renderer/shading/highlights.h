// Highlights: phong (R·L)^phong_size + specular (N·H)^(1/roughness), where a term counts only if its cosine is above 0.
// R is the view mirrored in the surface, and H is halfway between the ways to the light and to the eye.
#pragma once

#include "renderer/numerics/power.h"
#include "renderer/shading/material.h"

#include <array>
#include <cstddef>
#include <span>

namespace isl::render {

using scene::Vec3;

/// Adds the highlights of many points: their powers are found together.
class Highlights {
 public:
  /// Adds the highlight to every channel of `sum`, at the latest in finish(). All directions have unit length; `view`
  /// is the way from the eye. `share(c)` is a factor of a highlight whose light is mirrored at this cosine: for phong,
  /// as in POV-Ray, that to the normal, for specular that to the halfway direction.
  template <class Share>
  void add(const Material& material, const Vec3& normal, const Vec3& view, const Vec3& to_light, Rgb& sum,
           const Share& share) {
    if (material.phong > 0) {
      const Vec3 mirrored = view - normal * (2 * normal.dot(view));
      add(material.phong * share(normal.dot(to_light)), mirrored.dot(to_light), material.finish->phong_size, sum);
    }
    if (material.specular > 0) {
      const Vec3 halfway = to_light - view;
      const double length = halfway.length();
      if (length > 0)
        add(material.specular * share(halfway.dot(to_light) / length), halfway.dot(normal) / length,
            material.specular_exponent, sum);
    }
  }
  void add(const Material& material, const Vec3& normal, const Vec3& view, const Vec3& to_light, Rgb& sum) {
    add(material, normal, view, to_light, sum, [](double /*cosine*/) { return 1.0; });
  }
  void finish() {
    std::array<double, kMost> heights;
    powers(std::span(cosines_).first(count_), std::span(exponents_).first(count_), std::span(heights).first(count_));
    for (std::size_t i = 0; i < count_; ++i) *sums_[i] += Rgb(amounts_[i] * heights[i]);
    count_ = 0;
  }

 private:
  static constexpr std::size_t kMost = 64;

  void add(double amount, double cosine, double exponent, Rgb& sum) {
    if (!(cosine > 0) || is_dark(cosine, exponent)) return;
    if (count_ == kMost) finish();
    amounts_[count_] = amount;
    cosines_[count_] = cosine;
    exponents_[count_] = exponent;
    sums_[count_++] = &sum;
  }
  /// True if cosine^exponent is certainly below the least number of single precision: no picture holds it.
  [[nodiscard]] static bool is_dark(double cosine, double exponent) {
    // ln c ≤ c − 1, and 2⁻¹⁵⁰ = e^−103.97.
    return exponent * (cosine - 1) < -104;
  }

  std::array<double, kMost> amounts_, cosines_, exponents_;
  std::array<Rgb*, kMost> sums_;
  std::size_t count_ = 0;
};

}  // namespace isl::render
