// Conversions between the three spaces of a colour: the scene's working space (where POV-Ray's lighting is computed),
// linear light (the film, EXR), and display code values (PNG and other integer files, always sRGB).
//
// In POV-Ray 3.7, as observed, a working value v means the light v^g with `assumed_gamma g`, and with `assumed_gamma
// srgb` the light for which sRGB has the code v; version 3.7 without assumed_gamma is 1.0. Its PNG files are sRGB in
// each case. A scene of a version before 3.7 without assumed_gamma has its values written as they are, so a viewer
// shows them by the sRGB curve, which is the same as `srgb`.
#pragma once

#include "renderer/shading/material.h"

#include <span>

namespace isl::render {

/// Converts the working space to linear light.
class WorkingSpace {
 public:
  explicit WorkingSpace(const scene::Settings& settings);

  /// Negative values keep their sign.
  [[nodiscard]] Rgb to_linear(const Rgb& colour) const { return curve_ == Curve::linear ? colour : bent(colour); }

  /// The same for each of the colours, in place, and faster than one by one.
  void make_linear(std::span<Rgb> colours) const;

  /// True if the working space is linear light.
  [[nodiscard]] bool is_linear() const { return curve_ == Curve::linear; }

 private:
  enum class Curve { linear, power, srgb };
  [[nodiscard]] Rgb bent(const Rgb& colour) const;
  /// A value's curve is a power of `base(value)`, as `from_power` takes it.
  [[nodiscard]] double base(double value) const;
  [[nodiscard]] double from_power(double power, double value) const;
  [[nodiscard]] double bent(double value) const;

  Curve curve_ = Curve::linear;
  double gamma_ = 1;  ///< the exponent of the curve
};

/// IEC 61966-2-1. Both functions continue beyond 1 by the same law, and below 0 by its straight piece.
[[nodiscard]] double srgb_from_linear(double linear);
[[nodiscard]] double linear_from_srgb(double code);

/// The code value that a display gets for linear light: clipped to [0, 1] (NaN is 0), then sRGB.
[[nodiscard]] double display_from_linear(double linear);

}  // namespace isl::render
