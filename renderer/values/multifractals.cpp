#include "renderer/values/multifractals.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise.h"

#include <algorithm>
#include <cmath>

namespace isl::values {
namespace {

/// For a lacunarity of 2, this is more octaves than the range of doubles holds between the largest and the smallest
/// detail.
constexpr double kMaxOctaves = 2048;

/// Noise about zero at the frequency of octave i, and the amplitude that goes with it.
class Spectrum {
 public:
  explicit Spectrum(const double* p)
      : point_(p[0], p[1], p[2]), roughness_(p[3]), lacunarity_(p[4]), generator_(noise_generator_of(p[8])) {}

  void next() {
    point_ *= lacunarity_;
    ++octave_;
  }
  [[nodiscard]] double signed_noise() const { return 2 * noise(point_, generator_) - 1; }
  [[nodiscard]] double amplitude() const { return std::pow(lacunarity_, -roughness_ * octave_); }

 private:
  scene::Vec3 point_;
  double roughness_, lacunarity_;
  int octave_ = 0;
  NoiseGenerator generator_;
};

}  // namespace

double heterogeneous_multifractal(const double* p) {
  Spectrum spectrum(p);
  const double octaves = std::min(p[5], kMaxOctaves), offset = p[6];
  const int exponent = to_integer(p[7]);
  double value = offset + spectrum.signed_noise();
  for (int i = 1; i < octaves; ++i) {
    spectrum.next();
    const double weight = exponent >= 1 ? std::pow(value, exponent) : 1.0;
    value += (spectrum.signed_noise() + offset) * spectrum.amplitude() * weight;
  }
  const double part = octaves - std::trunc(octaves);
  if (part == 0) return value;
  spectrum.next();
  return value + part * (spectrum.signed_noise() + offset) * spectrum.amplitude() * value;
}

double ridged_multifractal(const double* p) {
  Spectrum spectrum(p);
  const double octaves = std::min(p[5], kMaxOctaves), offset = p[6], gain = p[7];
  const auto ridge = [&] {
    const double height = offset - std::abs(spectrum.signed_noise());
    return height * height;
  };
  double signal = ridge(), value = signal;
  for (int i = 1; i < octaves; ++i) {
    spectrum.next();
    signal = ridge() * std::clamp(signal * gain, 0.0, 1.0);
    value += signal * spectrum.amplitude();
  }
  return value;
}

}  // namespace isl::values
