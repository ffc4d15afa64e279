#include "tests/renderer/integrator/noise_scenes.h"

#include "renderer/film/surface_aovs.h"
#include "renderer/image/transfer.h"
#include "renderer/numerics/chance.h"
#include "tests/renderer/integrator/rendered_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::test {
namespace {

/// Numbers at random, one after the other.
class Chances {
 public:
  explicit Chances(std::uint32_t number) : number_(number) {}
  double between(double low, double high) { return low + (high - low) * render::chance_at(number_, next_++, 0); }
  bool one_in(int count) { return between(0, count) < 1; }

 private:
  double number_;
  double next_ = 0;
};

std::string colour(Chances& chances) {
  return fmt::format("pigment {{ rgb <{}, {}, {}> }} ", chances.between(0.1, 0.95), chances.between(0.1, 0.95),
                     chances.between(0.1, 0.95));
}

}  // namespace

std::string noise_scene(std::uint32_t number) {
  Chances chances(number);
  std::string settings;
  const bool has_sky = chances.one_in(3);
  if (has_sky) settings += fmt::format("sky_light {{ distance {} }} ", chances.between(1, 20));
  if (!has_sky && chances.one_in(3))
    settings += fmt::format("ambient_occlusion {{ distance {} }} ", chances.between(0.5, 4));
  if (chances.one_in(4)) settings += "bounce_light { } ";
  std::string text = fmt::format("#version 3.7; global_settings {{ assumed_gamma 1 {} }} ", settings);
  text += "background { rgb <.4, .5, .7> } ";
  const std::string blur = chances.one_in(2) ? fmt::format("focal_point <0, .5, {}> aperture {} blur_samples 9 ",
                                                           chances.between(-2, 2), chances.between(0.1, 0.8))
                                             : "";
  text += fmt::format("camera {{ location <{}, {}, -6> look_at <0, .6, 0> angle 45 {} }} ", chances.between(-2, 2),
                      chances.between(1, 4), blur);
  text += fmt::format("light_source {{ <{}, {}, {}> rgb .9 area_light {}*x, {}*z, 8, 8 {} jitter }} ",
                      chances.between(-5, 5), chances.between(3, 8), chances.between(-6, 2), chances.between(0.5, 4),
                      chances.between(0.5, 4), chances.one_in(3) ? "circular" : "");
  text += chances.one_in(2) ? "plane { y, 0 pigment { checker rgb .8, rgb <.3, .4, .5> } } "
                            : "plane { y, 0 pigment { rgb .8 } } ";
  for (int i = 0; i < 5; ++i) {
    const double radius = chances.between(0.2, 0.8);
    text +=
        fmt::format("sphere {{ <{}, {}, {}>, {} {} {} }} ", chances.between(-2.5, 2.5), radius, chances.between(-2, 4),
                    radius, colour(chances), chances.one_in(4) ? "finish { reflection .4 }" : "");
  }
  text += "blob { kernel \"gaussian\" hardness 4 ";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("sphere {{ <{}, {}, {}>, {} }} ", chances.between(-1, 1), chances.between(0.3, 1.6),
                        chances.between(-1, 1), chances.between(0.15, 0.4));
  return text + colour(chances) + "}";
}

double noise_over_asked(const std::string& scene, double max_noise, int samples, int size) {
  render::RenderOptions options;
  options.max_noise = max_noise;
  options.aovs = {&render::samples_aov()};
  const render::RenderResult picture = rendered(scene, size, options);
  options.max_noise.reset();
  options.samples = samples;
  const render::RenderResult truth = rendered(scene, size, options);
  double squares = 0;
  int pixels = 0;
  const int first = render::first_samples(picture.statistics.plan);
  for (std::size_t i = 0; i < picture.image.window.area(); ++i) {
    if (picture.image.layers.front().values[i] <= first) continue;
    ++pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto code = [&](const render::Image& image) { return render::display_from_linear(image.rgba[4 * i + c]); };
      squares += std::pow(code(picture.image) - code(truth.image), 2) / 3;
    }
  }
  return pixels < 100 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / pixels) / max_noise;
}

}  // namespace isl::test
