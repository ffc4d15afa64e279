// Scenes with soft light at random, and how honest the rule is that stops their samples.
#pragma once

#include "renderer/render.h"

#include <cstdint>
#include <string>

namespace isl::test {

/// The text of a scene, which depends on the number alone.
[[nodiscard]] std::string noise_scene(std::uint32_t number);

/// The root mean square of the error of a picture that stops at `max_noise`, in codes of a display over the channels of
/// the pixels with more than the first samples, over that noise. The truth is the picture of `samples` samples. NaN if
/// there are fewer than a hundred such pixels.
[[nodiscard]] double noise_over_asked(const std::string& scene, double max_noise, int samples, int size);

}  // namespace isl::test
