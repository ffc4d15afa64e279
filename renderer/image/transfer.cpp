#include "renderer/image/transfer.h"

#include "renderer/numerics/power.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isl::render {
namespace {

/// The code up to which sRGB is a straight line.
constexpr double kSrgbEnd = 0.04045;

/// The results of 0 and −0 differ, and NaN is not equal to itself.
bool has_same_bits(const Rgb& a, const Rgb& b) {
  const auto differing = [](double u, double v) {
    return std::bit_cast<std::uint64_t>(u) ^ std::bit_cast<std::uint64_t>(v);
  };
  return (differing(a.x, b.x) | differing(a.y, b.y) | differing(a.z, b.z)) == 0;
}

}  // namespace

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double code) { return code <= kSrgbEnd ? code / 12.92 : power((code + 0.055) / 1.055, 2.4); }

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
  if (curve_ == Curve::srgb) gamma_ = 2.4;
}

double WorkingSpace::base(double value) const {
  return curve_ == Curve::srgb ? (std::max(value, kSrgbEnd) + 0.055) / 1.055 : std::abs(value);
}

double WorkingSpace::from_power(double power, double value) const {
  if (curve_ == Curve::power) return std::copysign(power, value);
  return value <= kSrgbEnd ? value / 12.92 : power;
}

double WorkingSpace::bent(double value) const { return from_power(power(base(value), gamma_), value); }

Rgb WorkingSpace::bent(const Rgb& colour) const { return {bent(colour.x), bent(colour.y), bent(colour.z)}; }

void WorkingSpace::make_linear(std::span<Rgb> colours) const {
  if (is_linear()) return;
  constexpr std::size_t kMost = 64;
  std::array<Rgb, kMost> distinct;  // neighbours on a background or a flat surface have the same colour
  std::array<std::uint8_t, kMost> number;
  std::array<double, 3 * kMost> bases, exponents, curved;
  exponents.fill(gamma_);
  for (; !colours.empty(); colours = colours.subspan(std::min(kMost, colours.size()))) {
    const std::span<Rgb> some = colours.first(std::min(kMost, colours.size()));
    std::size_t count = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (count == 0 || !has_same_bits(some[i], distinct[count - 1])) distinct[count++] = some[i];
      number[i] = static_cast<std::uint8_t>(count - 1);
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k) bases[3 * i + static_cast<std::size_t>(k)] = base(distinct[i][k]);
    }
    powers(std::span(bases).first(3 * count), std::span(exponents).first(3 * count),
           std::span(curved).first(3 * count));
    for (std::size_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k)
        distinct[i][k] = from_power(curved[3 * i + static_cast<std::size_t>(k)], distinct[i][k]);
    }
    for (std::size_t i = 0; i < some.size(); ++i) some[i] = distinct[number[i]];
  }
}

}  // namespace isl::render
