// Lights with `jitter`, focal blur, occlusion, light from the sky and from surfaces, against closed forms.
#include "tests/renderer/integrator/middle_pixel.h"

#include <array>
#include <numbers>

namespace isl::test {
namespace {

/// The error that a mean over this many points may have: the integrands are edges at most, for which the standard
/// deviation of a scrambled net of n points is about 0.4 n^-3/4 (see SamplePoints, edges_converge_as_they_should).
/// Three of these.
constexpr int kSamples = 4096;
constexpr double kError = 3 * 0.4 / 512;

/// The middle pixel of a scene whose soft parts get kSamples points.
double grey_of(const std::string& scene) {
  render::RenderOptions options;
  options.samples = kSamples;
  options.crop = render::PixelRect{8, 8, 9, 9};
  return rendered(kHead + scene, 17, options).image.rgba[0];
}

/// A scene seen along z at x, so closely that the middle pixel is a point.
std::string seen_at(double x, const std::string& scene) {
  return fmt::format("camera {{ location <{}, 0, -5> direction z right .001*x up .001*y }} ", x) + scene;
}

/// Half of the light is hidden: light of x = a reaches the point x of the plane z = 0 if a > -x.
std::string half_lit(double x, const std::string& light) {
  return seen_at(x, fmt::format("light_source {{ -2*z rgb 1 {} }} "
                                "box {{ <-99, -99, -1.0001>, <0, 99, -1> no_image }} ",
                                light) +
                        plane("diffuse 1", "1"));
}

/// The share of light that falls on the plane, which the light's centre decides.
double cosine_at(double x) { return 2 / std::sqrt(4 + x * x); }

TEST(JitteredLight, is_even_over_2_to_the_k_points_a_side) {
  // Points at -1/2 to 1/2, each moved by up to half of a seventh: together 8/7 wide.
  for (const double x : {-0.6, -0.4, -0.1, 0.05, 0.3, 0.55}) {
    const double share = std::clamp(0.5 + x * 7 / 8, 0.0, 1.0);
    EXPECT_NEAR(grey_of(half_lit(x, "area_light x, y, 8, 8 jitter")), share * cosine_at(x), kError) << x;
  }
}

TEST(JitteredLight, of_2_to_the_k_plus_1_points_weighs_those_at_the_borders_half) {
  // Cells of a quarter, whose weights are 1, 2, 2, 2, 1 eighths.
  const auto share_to_the_right_of = [](double a) {
    constexpr std::array kWeights{1, 2, 2, 2, 1};
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      const double begin = -0.625 + 0.25 * i;
      sum += kWeights[static_cast<std::size_t>(i)] / 8.0 * std::clamp((begin + 0.25 - a) / 0.25, 0.0, 1.0);
    }
    return sum;
  };
  for (const double x : {-0.5, -0.3, 0.1, 0.45}) {
    EXPECT_NEAR(grey_of(half_lit(x, "area_light x, y, 5, 5 jitter")), share_to_the_right_of(-x) * cosine_at(x), kError)
        << x;
  }
}

TEST(JitteredLight, that_is_circular_has_the_density_of_its_map) {
  // Quadrature over the square that is pressed into the disc.
  const auto share = [](double x) {
    constexpr int kCells = 2000;
    int lit = 0;
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        const auto across = [](int cell) { return ((cell + 0.5) / kCells * 8 - 0.5) / 7 - 0.499; };
        const double a = across(i), b = across(j);
        lit += a * std::max(std::abs(a), std::abs(b)) / std::hypot(a, b) > -x ? 1 : 0;
      }
    }
    return static_cast<double>(lit) / kCells / kCells;
  };
  for (const double x : {-0.45, -0.2, 0.1, 0.4}) {
    EXPECT_NEAR(grey_of(half_lit(x, "area_light x, y, 8, 8 circular jitter")), share(x) * cosine_at(x), kError) << x;
  }
}

TEST(JitteredLight, with_area_illumination_shines_from_all_its_points) {
  // Quadrature of the cosine over the light, of which nothing is hidden.
  double mean = 0;
  constexpr int kCells = 200;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double a = ((i + 0.5) / kCells - 0.5) * 8 / 7 * 3, b = ((j + 0.5) / kCells - 0.5) * 8 / 7 * 3;
      mean += 2 / std::sqrt(4 + (a - 0.5) * (a - 0.5) + b * b) / kCells / kCells;
    }
  }
  const std::string scene = "light_source { -2*z rgb 1 area_light 3*x, 3*y, 8, 8 area_illumination jitter } ";
  EXPECT_NEAR(grey_of(seen_at(0.5, scene + plane("diffuse 1", "1"))), mean, kError);
}

TEST(JitteredLight, takes_its_points_once_whatever_the_number_of_samples) {
  const std::string scene = half_lit(0.1, "area_light x, y, 4, 4 jitter");
  for (const auto& [samples, shadow_rays] : {std::pair(1, 16), {4, 16}, {16, 16}, {64, 64}}) {
    render::RenderOptions options;
    options.samples = samples;
    options.crop = render::PixelRect{8, 8, 9, 9};
    EXPECT_EQ(rendered(kHead + scene, 17, options).statistics.paths.shadow, shadow_rays) << samples;
  }
}

/// A camera at -5 z, in focus at z = 0, that looks at the edge of a white half-plane at z = 5, `offset` from it.
std::string blurred_edge(double offset, double aperture) {
  return fmt::format(
      "camera {{ location <{}, 0, -5> direction z right .001*x up .001*y focal_point <{}, 0, 0> aperture {} "
      "blur_samples 9 }} box {{ <0, -99, 5>, <99, 99, 5.0001> pigment {{ rgb 1 }} finish {{ ambient 1 diffuse 0 }} }} ",
      offset, offset, aperture);
}

TEST(FocalBlur, spreads_a_point_over_a_disc) {
  // A ray from o on the lens meets the plane z = 5 at offset - o, because it passes the axis halfway. The lens has the
  // radius aperture/4, and the share of a disc on one side of a line is that of a segment.
  const double aperture = 1.6, radius = aperture / 4;
  for (const double offset : {-0.41, -0.39, -0.2, 0.0, 0.1, 0.35, 0.41}) {
    const double t = std::clamp(offset / radius, -1.0, 1.0);
    const double share = 0.5 + (std::asin(t) + t * std::sqrt(1 - t * t)) / std::numbers::pi;
    EXPECT_NEAR(grey_of(blurred_edge(offset, aperture)), share, kError) << offset;
  }
}

TEST(FocalBlur, leaves_what_is_in_focus_sharp) {
  const std::string scene =
      "camera { location <.0004, 0, -5> direction z right .001*x up .001*y focal_point 0 aperture 3 blur_samples 9 } "
      "box { <0, -99, 0>, <99, 99, 6> pigment { rgb 1 } finish { ambient 1 diffuse 0 } } ";
  EXPECT_EQ(grey_of(scene), 1);
}

TEST(FocalBlur, takes_the_lens_from_a_bokeh) {
  // Only the right half of the lens, which is a square, is bright: rays come from x of 0 to the half of the side.
  const std::string bokeh = "bokeh { pigment { gradient x color_map { [.5 rgb 0] [.5 rgb 1] } } } }";
  for (const double offset : {-0.3, 0.1, 0.2, 0.3, 0.5}) {
    std::string scene = blurred_edge(offset, 1.6);
    scene.replace(scene.find(" }"), 2, " " + bokeh);
    EXPECT_NEAR(grey_of(scene), std::clamp(offset / 0.4, 0.0, 1.0), kError) << offset;
  }
}

/// A floor with settings of light from around, seen from above at x.
std::string floor_at(double x, const std::string& settings, const std::string& finish, const std::string& scene) {
  return fmt::format(
      "global_settings {{ {} }} camera {{ location <{}, 50, 0> look_at <{}, 0, 0> right .0001*x up .0001*z "
      "sky z }} plane {{ y, 0 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 {} }} }} {}",
      settings, x, x, finish, scene);
}

TEST(AmbientOcclusion, of_a_plane_under_a_ball_is_its_form_factor) {
  // A ball of radius r above the horizon, its centre at the distance d and the angle θ from the normal, hides
  // (r/d)² cos θ of the light that falls in by cosines.
  const double radius = 0.8, height = 1.5;
  for (const double x : {0.0, 0.5, 1.0, 2.0}) {
    const double distance = std::hypot(x, height);
    const double hidden = radius * radius / (distance * distance) * height / distance;
    const std::string ball = fmt::format("sphere {{ {}*y, {} no_image }} ", height, radius);
    EXPECT_NEAR(grey_of(floor_at(x, "ambient_occlusion { distance 100 samples 4 }", "ambient 1", ball)), 1 - hidden,
                kError)
        << x;
  }
}

TEST(AmbientOcclusion, inside_a_box_depends_on_the_distance) {
  const std::string box = "box { <-1, -1, -1>, <1, 2, 1> no_image inverse } ";
  for (const auto& [distance, value] : {std::pair(0.9, 1), {9, 0}}) {
    const std::string settings = fmt::format("ambient_occlusion {{ distance {} }}", distance);
    EXPECT_EQ(grey_of(floor_at(0, settings, "ambient 1", box)), value) << distance;
  }
}

TEST(AmbientOcclusion, does_not_see_objects_without_radiosity) {
  const std::string ball = "sphere { 1.5*y, .8 no_image no_radiosity } ";
  EXPECT_NEAR(grey_of(floor_at(0, "ambient_occlusion { distance 100 }", "ambient 1", ball)), 1, 1e-12);
}

TEST(SkyLight, of_an_even_sky_is_the_same_everywhere_on_a_ball) {
  const std::string scene =
      "background { rgb .7 } global_settings { sky_light { distance 50 } } sphere { 0, 1 pigment { rgb .5 } finish { "
      "ambient 1 diffuse .6 } } camera { location -5*z look_at ";
  for (const char* place : {"0", "<.7, 0, 0>", "<.3, .4, 0>"})
    EXPECT_NEAR(grey_of(scene + place + " right .001*x up .001*y }"), 0.7 * 0.5 * 0.6, 1e-9) << place;
}

TEST(SkyLight, of_a_gradient_is_its_mean_by_cosines) {
  // The sky is (1 + y)/2: its mean by cosines about a normal n is 1/2 + n.y/3.
  const std::string sky =
      "sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 2 translate -1 } } global_settings { "
      "sky_light { } } ";
  EXPECT_NEAR(grey_of(sky + "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } camera { location 9*y "
                            "look_at 0 right .001*x up .001*z sky z }"),
              5.0 / 6, kError);
  EXPECT_NEAR(grey_of(sky + "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } camera { location -9*z "
                            "look_at 0 right .001*x up .001*y }"),
              0.5, kError);
}

TEST(SkyLight, finds_a_small_bright_part_of_the_sky) {
  // A sun of 10 degrees at the zenith: sin²(10°) of the light by cosines, times its brightness.
  const std::string sky =
      "sky_sphere { pigment { gradient y color_map { [.992403876506104 rgb 0] [.992403876506104 rgb 40] } scale 2 "
      "translate -1 } } global_settings { sky_light { } } ";
  const double expected = 40 * std::pow(std::sin(std::numbers::pi / 18), 2);
  EXPECT_NEAR(grey_of(sky + "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } camera { location 9*y "
                            "look_at 0 right .001*x up .001*z sky z }"),
              expected, 3 * kError * expected);
}

TEST(BounceLight, from_a_wall_is_its_form_factor) {
  // An endless wall at a right angle to the floor fills half of what a point of the floor sees, by cosines.
  const std::string wall = "plane { -x, -3 pigment { rgb .8 } finish { ambient 1 diffuse 0 } } ";
  EXPECT_NEAR(grey_of(floor_at(0, "bounce_light { }", "diffuse .5", wall)), 0.5 * 0.5 * 0.8, kError);
}

TEST(BounceLight, ends_after_one_surface_and_at_its_distance) {
  const std::string wall = "plane { -x, -3 pigment { rgb .8 } finish { ambient 1 diffuse 1 } } ";
  const std::string far = "bounce_light { distance 2.9 }";
  EXPECT_EQ(grey_of(floor_at(0, far, "diffuse .5", wall)), 0);
  EXPECT_NEAR(grey_of(floor_at(0, "bounce_light { }", "diffuse .5", wall)), 0.2, kError)
      << "the wall does not get light from the floor, and the floor none that the wall gets from it";
}

TEST(SoftLight, gives_the_same_bytes_whatever_the_threads_the_order_and_the_crop) {
  const std::string scene =
      "global_settings { assumed_gamma 2.2 sky_light { } bounce_light { samples 2 } } background { rgb .5 } camera { "
      "location <0, 2, -6> look_at y*.7 focal_point 0 aperture .2 blur_samples 3 } light_source { <3, 5, -3> rgb 1 "
      "area_light x, y, 3, 3 jitter } plane { y, 0 pigment { rgb .9 } } sphere { y, 1 pigment { rgb <1, .4, .2> } "
      "finish { reflection { .3 exponent .8 } } }";
  for (const bool by_noise : {false, true}) {
    render::RenderOptions options;
    if (by_noise) options.max_noise = 0.03;
    options.threads = 1;
    const render::RenderResult one = rendered(scene, 40, options);
    options.threads = 3;
    options.tile_order = render::TileOrder::shuffled;
    EXPECT_EQ(one.image.rgba, rendered(scene, 40, options).image.rgba);
    options.crop = render::PixelRect{7, 11, 29, 30};
    const render::RenderResult part = rendered(scene, 40, options);
    for (int y = 11; y < 30; ++y) {
      for (int x = 7; x < 29; ++x) {
        for (std::size_t i = 0; i < 4; ++i) {
          ASSERT_EQ(part.image.rgba[4 * part.image.window.index(x, y) + i],
                    one.image.rgba[4 * one.image.window.index(x, y) + i]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace isl::test
