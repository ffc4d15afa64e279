// The colours into which dispersion parts white light.
//
// Each primary is a sum of parabolas over the place in the spectrum, 0 at its violet end and 1 at its red end. They are
// made to resemble the tints of POV-Ray's dispersed light, within 0.03 for seven colours, and each primary adds up to 1
// over the whole spectrum, so that rays of all colours together are white.
#pragma once

#include "renderer/shading/material.h"

#include <algorithm>
#include <cstdint>

namespace isl::render {

/// A wavelength, as its place in the spectrum. White light has none.
class Wave {
 public:
  Wave() = default;
  /// `place` is from 0 to 1.
  explicit Wave(double place) : code_(static_cast<std::uint16_t>(1 + place * kSteps)) {}

  [[nodiscard]] bool is_white() const { return code_ == 0; }
  /// The exponent of a medium's dispersion by which its index of refraction for this wavelength differs from the mean:
  /// from 1/2 for violet to −1/2 for red.
  [[nodiscard]] double bend() const { return is_white() ? 0 : 0.5 - (code_ - 1) / kSteps; }

 private:
  static constexpr double kSteps = 65534;
  std::uint16_t code_ = 0;
};

namespace detail {

/// The parabola height (1 − ((p − middle)/half_width)²), where it is above 0.
struct Lobe {
  double height, middle, half_width;

  /// Its integral from 0 to p.
  [[nodiscard]] constexpr double up_to(double p) const {
    const double first = std::max(middle - half_width, 0.0);
    return integral(std::clamp(p, first, std::min(middle + half_width, 1.0))) - integral(first);
  }
  [[nodiscard]] constexpr double integral(double p) const {
    const double x = p - middle;
    return height * (x - x * x * x / (3 * half_width * half_width));
  }
};

inline constexpr Lobe kRed{1, 0.785, 0.262}, kVioletRed{0.1, 0.085, 0.09}, kGreen{1, 0.585, 0.26},
    kBlue{1, 0.255, 0.275};

}  // namespace detail

/// The share of white light between the violet end of the spectrum and a place in it; 1 at its red end.
[[nodiscard]] inline Rgb light_up_to(double place) {
  const auto red = [](double p) { return detail::kRed.up_to(p) + detail::kVioletRed.up_to(p); };
  return {red(place) / red(1), detail::kGreen.up_to(place) / detail::kGreen.up_to(1),
          detail::kBlue.up_to(place) / detail::kBlue.up_to(1)};
}

}  // namespace isl::render
