// Area lights, light through windows, and lights of some objects only, in whole pictures.
#include "tests/renderer/integrator/middle_pixel.h"

#include <array>
#include <utility>
#include <vector>

namespace isl::test {
namespace {

/// A scene seen along z at x, so closely that the middle pixel is a point.
std::string at(double x, const std::string& scene) {
  return fmt::format("camera {{ location <{}, 0, -5> direction z right .001*x up .001*y }} ", x) + scene;
}

/// The x of pixel i of 17 that show x from -1 to 1.
double x_of(int i) {
  // The middle is moved, because rays from there touch the face of kHalf.
  return i == 8 ? -1e-5 : (i + .5) / 8.5 - 1;
}

void expect_grey(int pixel, const std::string& scene, double value) {
  expect_middle(at(x_of(pixel), scene), value, value, value, 2e-4);
}

const std::string kWhite = plane("diffuse 1", "1");
/// Darkens the left half of a light at -2*z for points of z = 0.
const std::string kHalf = "box { <-99, -99, -1.0001>, <0, 99, -1> no_image } ";

std::string light(const std::string& items, const std::string& scene = {}) {
  return fmt::format("light_source {{ -2*z rgb 1 {} }} {}", items, scene);
}

const std::string kHalfAndWhite = kHalf + kWhite;

TEST(AreaLight, is_povrays) {
  const std::string five = light("area_light x, y, 5, 5") + kHalf + kWhite;
  for (const auto& [pixel, value] : {std::pair(4, .12168), {7, .37435}, {8, .37501}, {9, .62393}, {12, .85174}})
    expect_grey(pixel, five, value);
  const std::string four = light("area_light x, y, 4, 4") + kHalf + kWhite;
  for (const auto& [pixel, value] : {std::pair(7, .49914), {8, .50001}, {10, .74487}}) expect_grey(pixel, four, value);
}

TEST(AreaLight, with_area_illumination_shines_from_all_its_points) {
  const std::string scene = light("area_light x, y, 5, 5 area_illumination") + kWhite;
  for (const auto& [pixel, value] : {std::pair(8, .97058), {11, .95776}, {14, .92186}})
    expect_grey(pixel, scene, value);
}

TEST(AreaLight, with_area_illumination_lights_what_its_centre_does_not) {
  // The centre lies in the plane, and two of the three points of a row before it: those at z = -1 and 0 light.
  const auto lit = [](const char* more) {
    return std::string("light_source { 4*x rgb 3 area_light 2*z, y, 3, 1 ") + more + " } " + kWhite;
  };
  expect_grey(8, lit(""), 0);
  expect_middle(at(0, lit("area_illumination shadowless")), 1 / std::sqrt(17.0), 1 / std::sqrt(17.0),
                1 / std::sqrt(17.0));
}

TEST(AreaLight, throws_coloured_shadows) {
  // Half of the light passes a filter.
  const std::string disc =
      "polygon { 5, <-99, -99>, <0, -99>, <0, 99>, <-99, 99>, <-99, -99> translate -z no_image pigment { rgbf "
      "<1, .25, 0, 1> } } " +
      kWhite;
  for (const char* items : {"area_light x, y, 4, 4", "area_light x, y, 4, 4 adaptive 0"})
    expect_middle(at(0, light(items, disc)), 1, .625, .5, 1e-4);
}

TEST(AreaLight, is_moved_by_transforms) {
  const std::string occluder = kHalf + kWhite;
  const auto value = [&](const char* source) {
    return middle_of(rendered(kHead + at(x_of(9), std::string(source) + occluder)).image).x;
  };
  const double written = value("light_source { -2*z rgb 1 area_light y, 2*x, 5, 7 } ");
  EXPECT_NE(written, value("light_source { -2*z rgb 1 area_light x, 2*y, 5, 7 } "));
  EXPECT_EQ(written, value("light_source { 0 rgb 1 area_light x, -2*y, 5, 7 rotate 90*z translate -2*z } "));
  EXPECT_EQ(written, value("light_source { -z/2 rgb 1 area_light x/4, -y/2, 5, 7 rotate 90*z scale 4 } "));
  EXPECT_EQ(written, value("union { light_source { 0 rgb 1 area_light x, -2*y, 5, 7 } rotate 90*z translate -2*z } "));
}

TEST(AreaLight, of_one_point_is_a_point_light) {
  const std::string scene = kHalf + kWhite;
  const auto picture = [&](const std::string& items) {
    return rendered(kHead + at(.01, light(items) + scene), 9).image.rgba;
  };
  EXPECT_EQ(picture("area_light x, y, 1, 1"), picture(""));
  EXPECT_EQ(picture("area_light x, y, 1, 1 circular adaptive 2").size(), picture("").size());
}

/// The shadow rays that one pixel takes.
std::uint64_t rays(double x, const std::string& items) {
  return rendered(kHead + at(x, light(items, kHalfAndWhite)), 1).statistics.paths.shadow;
}

TEST(AreaLight, that_is_adaptive_looks_closer_where_the_corners_differ) {
  // Fully lit and fully dark.
  EXPECT_EQ(rays(3, "area_light x, y, 9, 9 adaptive 0"), 4u);
  EXPECT_EQ(rays(-3, "area_light x, y, 9, 9 adaptive 0"), 4u);
  EXPECT_EQ(rays(3, "area_light x, y, 9, 9 adaptive 1"), 9u);
  EXPECT_EQ(rays(3, "area_light x, y, 9, 9 adaptive 2"), 25u);
  EXPECT_EQ(rays(3, "area_light x, y, 9, 9 adaptive 9"), 81u);
  EXPECT_EQ(rays(3, "area_light x, y, 9, 9"), 81u);
  // The edge is between two columns: each division asks for two more, and for the rows between those that are known.
  const std::uint64_t at_edge = rays(.01, "area_light x, y, 9, 9 adaptive 0");
  EXPECT_GT(at_edge, 9u);
  EXPECT_LT(at_edge, 81u);
}

TEST(AreaLight, that_is_adaptive_and_dark_needs_no_closer_look) {
  const auto dim = [](double colour) {
    const std::string source = fmt::format("light_source {{ -2*z rgb {} area_light x, y, 9, 9 adaptive 0 }} ", colour);
    return rendered(kHead + at(.01, source + kHalf + kWhite), 1).statistics.paths.shadow;
  };
  EXPECT_EQ(dim(.033), 4u) << "the corners differ by .099";
  EXPECT_GT(dim(.034), 4u);
}

TEST(AreaLight, has_the_same_shadow_where_adaptive_looks_everywhere) {
  for (const char* grid : {"9, 9", "7, 6", "1, 13", "4, 2"}) {
    for (const double x : {-.3, .01, .2}) {
      const auto value = [&](const char* more) {
        const std::string items = fmt::format("area_light x, 2*y, {} {}", grid, more);
        return middle_of(rendered(kHead + at(x, light(items, kHalfAndWhite))).image).x;
      };
      EXPECT_NEAR(value(""), value("adaptive 20"), 1e-12) << grid << ' ' << x;
    }
  }
}

TEST(AreaLight, that_scenes_can_do_without_is_a_point) {
  render::RenderOptions options;
  options.without = {"area_light"};
  const std::string scene = kHead + at(.3, light("area_light 2*x, y, 5, 5") + kHalf + kWhite);
  EXPECT_LT(middle_of(rendered(scene, 17).image).x, .9);
  EXPECT_NEAR(middle_of(rendered(scene, 17, options).image).x, std::pow(4 / 4.09, .5), 1e-4);
}

// ---- projected_through ----------------------------------------------------------------------------------------------

const std::string kWindow = "projected_through { box { <-.5, -.5, -1.1>, <.5, .5, -1> } } ";
/// The light of light() at x on z = 0.
double direct(double x) { return 2 / std::hypot(x, 2.0); }

TEST(ProjectedThrough, shines_through_the_object_alone) {
  for (const char* more : {"", "shadowless "}) {
    expect_grey(8, light(kWindow + more, kWhite), 1);
    expect_grey(14, light(kWindow + more, kWhite), direct(x_of(14)));
    expect_middle(at(1.2, light(kWindow + more, kWhite)), 0, 0, 0);
  }
}

TEST(ProjectedThrough, hides_what_stands_behind_the_object_and_nothing_before_it) {
  const std::string behind = "sphere { <0, 0, -1.5>, .1 no_image } ", before = "sphere { <0, 0, -.5>, .1 no_image } ";
  expect_grey(8, light(kWindow) + behind + kWhite, 1);
  expect_grey(8, light(kWindow) + before + kWhite, 0);
}

TEST(ProjectedThrough, counts_for_each_point_of_an_area_light) {
  // At x = 1 the ray from the point u of the light passes z = -1 at (1 + u)/2: through the window for the points at -2
  // and -2/3.
  for (const char* more : {"", "adaptive 0 ", "adaptive 3 "}) {
    const std::string row = light(std::string("area_light 4*x, y, 4, 1 ") + more + kWindow);
    expect_middle(at(1.01, row + kWhite), direct(1.01) / 2, direct(1.01) / 2, direct(1.01) / 2, 1e-3);
  }
}

TEST(ProjectedThrough, moves_with_its_light) {
  expect_middle(at(0,
                   "light_source { 0 rgb 1 projected_through { box { <-.1, -.1, .9>, <.1, .1, 1> translate x } } "
                   "translate <-1, 0, -2> } " +
                       kWhite),
                0, 0, 0);
  expect_middle(at(1,
                   "light_source { 0 rgb 1 projected_through { box { <-.1, -.1, .9>, <.1, .1, 1> } } scale 3 "
                   "translate <1, 0, -4> } " +
                       kWhite),
                1, 1, 1);
}

// ---- light_group ----------------------------------------------------------------------------------------------------

constexpr const char* kSun = "light_source { -1e6*z rgb <.5, 0, 0> } ";
constexpr const char* kSquare = "box { <-.4, -.4, 0>, <.4, .4, .5> pigment { rgb 1 } finish { ambient 0 diffuse 1 } ";

std::string green_group(const char* more) {
  return std::string("light_group { light_source { -1e6*z rgb <0, .5, 0> } ") + kSquare + "translate -x } " + more +
         " } ";
}

TEST(LightGroup, lights_its_objects_alone) {
  const std::string other = std::string(kSquare) + "translate x } ";
  expect_middle(at(-1, kSun + green_group("") + other), 0, .5, 0);
  expect_middle(at(1, kSun + green_group("") + other), .5, 0, 0);
  expect_middle(at(-1, kSun + green_group("global_lights on") + other), .5, .5, 0);
  expect_middle(at(1, kSun + green_group("global_lights on") + other), .5, 0, 0);
}

TEST(LightGroup, without_lights_is_dark) {
  expect_middle(at(0, std::string(kSun) + "light_group { " + kSquare + "} } "), 0, 0, 0);
  expect_middle(at(0, std::string(kSun) + "light_group { " + kSquare + "} global_lights on } "), .5, 0, 0);
}

TEST(LightGroup, moves_with_its_lights_wherever_it_is_placed) {
  const std::string lamp = std::string("#declare Lamp = light_group { light_source { -z rgb <0, 1, 0> } ") + kSquare +
                           "} } object { Lamp translate -2*x } light_group { Lamp scale 2 translate 2*x } " + kSun;
  expect_middle(at(-2, lamp), 0, 1, 0);
  expect_middle(at(2, lamp), 0, 1, 0);
  // The light is twice as far away: 2/sqrt(4.25) of it at half a unit beside the middle.
  expect_middle(at(2.5, lamp), 0, 2 / std::sqrt(4.25), 0);
}

TEST(LightGroup, takes_the_lights_of_the_innermost_and_the_world_as_the_outermost_says) {
  const auto nest = [](const char* outer, const char* inner) {
    return std::string(kSun) +
           "light_group { light_source { -1e6*z rgb <0, .5, 0> } light_group { light_source { "
           "-1e6*z rgb <0, 0, .5> } " +
           kSquare + "} " + inner + " } " + kSquare + "translate x } " + outer + " } ";
  };
  expect_middle(at(0, nest("", "global_lights on")), 0, 0, .5);
  expect_middle(at(1, nest("", "global_lights on")), 0, .5, 0);
  expect_middle(at(0, nest("global_lights on", "global_lights off")), .5, 0, .5);
}

TEST(LightGroup, has_shadows_of_everything) {
  const std::string shade = "sphere { <-1, 0, -2>, .1 no_image } ";
  expect_middle(at(-1, green_group("") + shade), 0, 0, 0);
  expect_middle(at(-.8, green_group("") + shade), 0, .5, 0);
}

// ---- Fog on the way of light ----------------------------------------------------------------------------------------

TEST(MediaAttenuation, dims_light_by_the_fog_before_it) {
  // The camera is in the fog, too: half of its distance.
  const auto lit = [](const char* items, const char* fog, double value) {
    expect_middle(fmt::format("camera {{ location -5*z direction z right .001*x up .001*y }} fog {{ distance 10 {} }} "
                              "light_source {{ -2*z rgb 1 {} }} ",
                              fog, items) +
                      kWhite,
                  value, value, value);
  };
  const double seen = std::exp(-.5), way = std::exp(-.2);
  lit("", "rgb 0", seen);
  lit("media_attenuation on", "rgb 0", seen * way);
  lit("media_attenuation on media_interaction off", "rgb 0", seen);
  lit("media_attenuation on", "rgbt <0, 0, 0, .9>", .9 * .9);
  lit("media_attenuation on area_light x/1000, y/1000, 5, 5", "rgb 0", seen * way);
}

}  // namespace
}  // namespace isl::test
