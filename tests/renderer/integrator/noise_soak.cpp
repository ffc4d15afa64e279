// noise_soak [FIRST [COUNT [NOISE]]]: how far the noise of pictures is from what was asked for, for scenes at random.
// Wanted: between a half and the whole of it on nine of ten.
#include "tests/renderer/integrator/noise_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <span>

int main(int argc, char** argv) {
  const std::span arguments(argv, static_cast<std::size_t>(argc));
  const auto number = [&](std::size_t i, double otherwise) {
    return i < arguments.size() ? std::atof(arguments[i]) : otherwise;
  };
  const auto first = static_cast<std::uint32_t>(number(1, 1)), count = static_cast<std::uint32_t>(number(2, 100));
  const double noise = number(3, 0.02);
  constexpr int kSamples = 4096, kSize = 48;
  int good = 0, told = 0;
  for (std::uint32_t scene = first; scene < first + count; ++scene) {
    const double ratio = isl::test::noise_over_asked(isl::test::noise_scene(scene), noise, kSamples, kSize);
    if (std::isnan(ratio)) continue;
    ++told;
    good += ratio >= 0.5 && ratio <= 1 ? 1 : 0;
    fmt::print("{:5} {:.3f}{}\n", scene, ratio, ratio >= 0.5 && ratio <= 1 ? "" : " *");
  }
  fmt::print("{} of {} between a half and the whole of {}\n", good, told, noise);
}
