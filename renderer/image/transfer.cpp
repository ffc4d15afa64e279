#include "renderer/image/transfer.h"

#include "renderer/numerics/power.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double code) { return code <= 0.04045 ? code / 12.92 : power((code + 0.055) / 1.055, 2.4); }

double display_from_linear(double linear) {
  return linear > 0 ? std::min(srgb_from_linear(std::min(linear, 1.0)), 1.0) : 0;
}

WorkingSpace::WorkingSpace(const scene::Settings& settings) {
  if (settings.assumed_gamma_srgb) {
    curve_ = Curve::srgb;
  } else if (settings.assumed_gamma) {
    gamma_ = *settings.assumed_gamma;
    curve_ = gamma_ == 1 ? Curve::linear : Curve::power;
  } else {
    // Version 3.7 and later take 1.0 if the scene does not set it.
    curve_ = settings.language_version >= 3.7 ? Curve::linear : Curve::srgb;
  }
}

double WorkingSpace::bent(double value) const {
  if (curve_ == Curve::srgb) return linear_from_srgb(value);
  return std::copysign(power(std::abs(value), gamma_), value);
}

Rgb WorkingSpace::bent(const Rgb& colour) const { return {bent(colour.x), bent(colour.y), bent(colour.z)}; }

}  // namespace isl::render
