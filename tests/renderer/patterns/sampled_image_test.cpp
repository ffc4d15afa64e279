// Lookups in images against closed forms: where each map type finds its texels, what each interpolation makes of them,
// and what codes, alpha and palettes mean.
#include "renderer/patterns/kinds/sampled_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::Colour;
using scene::Vec3;

/// Texels of 8 bits, row by row from the top.
std::shared_ptr<Texels> texels(int width, int height, int channels, const std::vector<int>& codes) {
  auto result = std::make_shared<Texels>();
  result->width = width;
  result->height = height;
  result->channels = channels;
  result->transfer = Transfer::linear;
  for (const int code : codes) result->values.push_back(static_cast<std::byte>(code));
  return result;
}

/// 3x2 greys; by columns from the left, by rows from below: 30 40 50, then 0 10 20.
std::shared_ptr<Texels> greys() { return texels(3, 2, 1, {0, 10, 20, 30, 40, 50}); }

/// A statement with these members: `with(&Image::once, true, …)`.
scene::Image with() { return {}; }
template <class Member, class Value, class... Rest>
scene::Image with(Member member, Value value, Rest... rest) {
  scene::Image image = with(rest...);
  image.*member = value;
  return image;
}

SampledImage sampled(const scene::Image& image, std::shared_ptr<const Texels> of, const WorkingGamma& working = {}) {
  return {image, std::move(of), working};
}

/// The red of the image at a point, in codes; −1 where there is no image.
double code_at(const SampledImage& image, const Vec3& p) {
  const auto place = image.placing().place_of(p);
  return place ? 255 * image.colour_at(*place).red : -1;
}

TEST(SampledImage, planar_fills_the_unit_square_and_repeats) {
  const SampledImage image = sampled({}, greys());
  EXPECT_NEAR(code_at(image, {0.1, 0.1, 0}), 30, 1e-4);
  EXPECT_NEAR(code_at(image, {0.5, 0.6, 7}), 10, 1e-4);
  EXPECT_NEAR(code_at(image, {0.99, 0.99, 0}), 20, 1e-4);
  EXPECT_NEAR(code_at(image, {1.1, 0.1, 0}), 30, 1e-4);
  EXPECT_NEAR(code_at(image, {-0.1, -0.1, 0}), 20, 1e-4);
}

TEST(SampledImage, once_has_no_colour_outside) {
  const SampledImage image = sampled(with(&scene::Image::once, true), greys());
  EXPECT_NEAR(code_at(image, {0.1, 0.1, 0}), 30, 1e-4);
  EXPECT_NEAR(code_at(image, {1, 1, 0}), 20, 1e-4);
  for (const Vec3& p : {Vec3(-0.01, 0.5, 0), Vec3(1.01, 0.5, 0), Vec3(0.5, -0.01, 0), Vec3(0.5, 1.01, 0)})
    EXPECT_EQ(code_at(image, p), -1) << p;
}

TEST(SampledImage, is_repeated_and_moved) {
  const SampledImage image =
      sampled(with(&scene::Image::repeat_x, 2, &scene::Image::repeat_y, 3, &scene::Image::offset_x, 0.5), greys());
  // 2 · 0.3 − 0.5 = 0.1 and 3 · 0.4 = 1.2.
  EXPECT_NEAR(code_at(image, {0.3, 0.4, 0}), 30, 1e-4);
  EXPECT_NEAR(code_at(image, {0.7, 0.55, 0}), 20, 1e-4);
}

TEST(SampledImage, spherical_takes_longitude_and_latitude) {
  const SampledImage image = sampled(with(&scene::Image::map_type, 1), greys());
  const auto at = [](double turn, double latitude, double radius) {
    const double a = turn * 2 * std::numbers::pi;
    return Vec3(std::cos(a) * std::cos(latitude), std::sin(latitude), std::sin(a) * std::cos(latitude)) * radius;
  };
  EXPECT_NEAR(code_at(image, at(0.1, -0.3, 1)), 30, 1e-4);
  EXPECT_NEAR(code_at(image, at(0.5, 0.3, 9)), 10, 1e-4);
  EXPECT_NEAR(code_at(image, at(0.9, 1.5, 0.1)), 20, 1e-4);
  EXPECT_TRUE(std::isfinite(code_at(image, Vec3(0))));
}

TEST(SampledImage, cylindrical_takes_longitude_and_height) {
  const SampledImage image = sampled(with(&scene::Image::map_type, 2, &scene::Image::once, true), greys());
  EXPECT_NEAR(code_at(image, {0, 0.2, 5}), 30, 1e-4) << "a quarter of a turn";
  EXPECT_NEAR(code_at(image, {-1, 0.7, 0.01}), 10, 1e-4);
  EXPECT_EQ(code_at(image, {1, 1.2, 0}), -1);
}

TEST(SampledImage, toroidal_begins_inside_and_goes_over_the_lower_side) {
  // One column of eight rows: the lowest is the first eighth of the way around the tube.
  const SampledImage image =
      sampled(with(&scene::Image::map_type, 5), texels(1, 8, 1, {70, 60, 50, 40, 30, 20, 10, 0}));
  for (int i = 0; i < 8; ++i) {
    const double around = (i + 0.5) / 8 * 2 * std::numbers::pi;
    EXPECT_NEAR(code_at(image, {1 - 0.3 * std::cos(around), -0.3 * std::sin(around), 0}), 10 * i, 1e-4) << i;
  }
}

TEST(SampledImage, bilinear_mixes_four_centres) {
  const SampledImage image = sampled(with(&scene::Image::interpolate, 2), greys());
  EXPECT_NEAR(code_at(image, {0.5 / 3, 0.25, 0}), 30, 1e-4) << "a centre";
  EXPECT_NEAR(code_at(image, {1 / 3., 0.5, 0}), (30 + 40 + 0 + 10) / 4., 1e-4);
  EXPECT_NEAR(code_at(image, {0.75 / 3, 0.25, 0}), 32.5, 1e-4);
  EXPECT_NEAR(code_at(image, {0, 0.25, 0}), 40, 1e-4) << "across the border";
  EXPECT_NEAR(code_at(sampled(with(&scene::Image::interpolate, 2, &scene::Image::once, true), greys()), {0, 0.25, 0}),
              30, 1e-4);
}

TEST(SampledImage, bicubic_passes_through_centres_and_keeps_straight_lines) {
  const auto ramp = texels(6, 1, 1, {0, 10, 20, 30, 40, 50});
  const SampledImage image = sampled(with(&scene::Image::interpolate, 3, &scene::Image::once, true), ramp);
  for (const double x : {1.5, 2.25, 2.5, 3.75, 4.5})
    EXPECT_NEAR(code_at(image, {x / 6, 0.5, 0}), 10 * (x - 0.5), 1e-3) << x;
  // Catmull and Rom half-way beside a step: (−a + 9b + 9c − d) / 16.
  const SampledImage step =
      sampled(with(&scene::Image::interpolate, 3, &scene::Image::once, true), texels(4, 1, 1, {0, 0, 160, 160}));
  EXPECT_NEAR(code_at(step, {2 / 4., 0.5, 0}), 80, 1e-3);
  EXPECT_NEAR(code_at(step, {3 / 4., 0.5, 0}), (9 * 160 + 9 * 160 - 160) / 16., 1e-3) << "it overshoots";
}

TEST(SampledImage, normalised_distance_weighs_by_the_inverse_square) {
  const SampledImage image = sampled(with(&scene::Image::interpolate, 4), greys());
  EXPECT_NEAR(code_at(image, {0.5 / 3, 0.25, 0}), 30, 1e-4) << "a centre";
  // At (0.25, 0) from the centre of 30: squares of distances 1/16 and 9/16, and with the rows above 17/16 and 25/16.
  const double weights[] = {16, 16 / 9., 16 / 17., 16 / 25.}, codes[] = {30, 40, 0, 10};
  double sum = 0, total = 0;
  for (int i = 0; i < 4; ++i) {
    sum += weights[i] * codes[i];
    total += weights[i];
  }
  EXPECT_NEAR(code_at(image, {0.75 / 3, 0.25, 0}), sum / total, 1e-3);
}

TEST(SampledImage, alpha_is_transmitted_light_and_all_adds_to_it) {
  const SampledImage image = sampled(with(&scene::Image::filter_all, 0.25, &scene::Image::transmit_all, 0.5),
                                     texels(1, 1, 4, {255, 51, 0, 204}));
  const Colour colour = image.colour_at(*image.placing().place_of(Vec3(0.5)));
  EXPECT_NEAR(colour.green, 0.2, 1e-6);
  EXPECT_NEAR(colour.filter, 0.25, 1e-6);
  EXPECT_NEAR(colour.transmit, 0.7, 1e-6);
}

TEST(SampledImage, palette_gets_the_transparency_of_its_numbers) {
  auto indices = texels(3, 1, 1, {0, 1, 2});
  indices->sample = Texels::Sample::index;
  indices->palette = {{255, 0, 0, 255}, {0, 255, 0, 51}, {0, 0, 255, 255}};
  scene::Image statement;
  statement.filters = {{2, 0.5}};
  statement.transmits = {{0, 0.75}};
  const SampledImage image = sampled(statement, indices);
  const auto at = [&](double x) { return image.colour_at(*image.placing().place_of({x, 0.5, 0})); };
  EXPECT_EQ(at(0.1), (Colour{1, 0, 0, 0, 0.75}));
  EXPECT_NEAR(at(0.5).transmit, 0.8, 1e-6) << "of the file";
  EXPECT_EQ(at(0.9), (Colour{0, 0, 1, 0.5, 0}));
  EXPECT_NEAR(image.height_at(*image.placing().place_of({0.9, 0.5, 0})), 0.114, 1e-6) << "the brightness of blue";
  statement.channel = scene::ImageChannel::index;
  EXPECT_EQ(sampled(statement, indices).height_at(*image.placing().place_of({0.9, 0.5, 0})), 2)
      << "the number of the colour";
}

TEST(SampledImage, gamma_is_the_named_one_then_the_files) {
  const auto red = [](const scene::Image& image, Transfer transfer, const WorkingGamma& working, bool states = false) {
    auto of = texels(1, 1, 1, {128});
    of->transfer = transfer;
    of->gamma = 1.8;
    of->states_transfer = states;
    return code_at(sampled(image, of, working), Vec3(0.5)) / 255;
  };
  const double code = 128 / 255., light = std::pow((code + 0.055) / 1.055, 2.4);
  const WorkingGamma linear, encoded{.kind = WorkingGamma::Kind::power, .gamma = 2.2},
      old{.converts = WorkingGamma::Converts::stating}, oldest{.converts = WorkingGamma::Converts::named};
  EXPECT_NEAR(red({}, Transfer::srgb, linear), light, 1e-6);
  EXPECT_NEAR(red({}, Transfer::power, linear), std::pow(code, 1.8), 1e-6);
  EXPECT_NEAR(red(with(&scene::Image::gamma, 2.0), Transfer::srgb, linear), code * code, 1e-6);
  EXPECT_NEAR(red(with(&scene::Image::gamma_srgb, true), Transfer::working, linear), light, 1e-6);
  EXPECT_NEAR(red({}, Transfer::working, linear), code, 1e-6);
  EXPECT_NEAR(red({}, Transfer::working, encoded), code, 1e-6);
  EXPECT_NEAR(red({}, Transfer::srgb, encoded), std::pow(light, 1 / 2.2), 1e-6);
  EXPECT_NEAR(red({}, Transfer::srgb, {.kind = WorkingGamma::Kind::srgb}), code, 1e-6);
  EXPECT_NEAR(red({}, Transfer::srgb, old), code, 1e-6);
  EXPECT_NEAR(red({}, Transfer::srgb, old, true), light, 1e-6);
  EXPECT_NEAR(red({}, Transfer::srgb, oldest, true), code, 1e-6);
  EXPECT_NEAR(red(with(&scene::Image::gamma, 2.0), Transfer::srgb, oldest), code * code, 1e-6);
  EXPECT_NEAR(red(with(&scene::Image::holds_numbers, true), Transfer::srgb, linear), code, 1e-6);
  EXPECT_NEAR(red(with(&scene::Image::gamma, 2.0, &scene::Image::holds_numbers, true), Transfer::srgb, linear),
              code * code, 1e-6);
}

TEST(SampledImage, keeps_16_bits) {
  auto wide = std::make_shared<Texels>();
  wide->width = wide->height = wide->channels = 1;
  wide->sample = Texels::Sample::bits16;
  wide->transfer = Transfer::linear;
  const std::uint16_t code = 12345;
  wide->values = {static_cast<std::byte>(code & 255), static_cast<std::byte>(code >> 8)};
  const SampledImage image = sampled(with(&scene::Image::holds_numbers, true), wide);
  EXPECT_NEAR(image.value_at(*image.placing().place_of(Vec3(0.5))), 12345 / 65535., 1e-7);
}

TEST(SampledImage, of_numbers_is_grey_or_transmitted_light) {
  const auto rgba = texels(1, 1, 4, {255, 0, 0, 102});
  const auto value = [&](scene::ImageChannel channel) {
    const SampledImage image = sampled(with(&scene::Image::channel, channel, &scene::Image::holds_numbers, true), rgba);
    return image.value_at(*image.placing().place_of(Vec3(0.5)));
  };
  EXPECT_NEAR(value(scene::ImageChannel::automatic), 0.297, 1e-6);
  EXPECT_NEAR(value(scene::ImageChannel::alpha), 0.6, 1e-6);
}

TEST(SampledImage, brightness_of_grey_bytes_is_whole_as_in_povray) {
  // In POV-Ray 3.7, an image_pattern of the grey 116 is 115/255, and of 18 it is 18/255.
  const auto value = [](int code) {
    const SampledImage image = sampled(with(&scene::Image::holds_numbers, true), texels(1, 1, 1, {code}));
    const TexelPlace place = *image.placing().place_of(Vec3(0.5));
    EXPECT_EQ(image.value_at(place), image.height_at(place));
    return 255 * image.value_at(place);
  };
  EXPECT_NEAR(value(116), 115, 1e-9);
  EXPECT_NEAR(value(18), 18, 1e-9);
}

TEST(SampledImage, chooses_textures_by_the_number_of_the_colour_or_by_red) {
  const auto choice = [](int code, bool is_index) {
    auto of = texels(1, 1, 1, {code});
    if (is_index) {
      of->sample = Texels::Sample::index;
      of->palette.resize(256);
    }
    scene::Image image;
    image.holds_numbers = true;
    image.choices = 5;
    const SampledImage chooser = sampled(image, of);
    return chooser.choice_at(*chooser.placing().place_of(Vec3(0.5)));
  };
  EXPECT_EQ(choice(3, true), 3);
  EXPECT_EQ(choice(4, false), 4);
  EXPECT_EQ(choice(5, true), 5) << "beyond the end, where the last texture is taken";
  EXPECT_EQ(choice(13, true), 3);
}

}  // namespace
}  // namespace isl::render
