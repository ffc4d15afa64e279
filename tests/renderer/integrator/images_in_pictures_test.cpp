// Images in whole pictures. They are those of functions, which need no files.
#include "tests/renderer/integrator/middle_pixel.h"

namespace isl::test {
namespace {

/// A plane seen straight on, whose middle pixel is the origin; without light, it shows its colour.
std::string sheet(const std::string& textures, const char* finish = "finish { ambient 1 diffuse 0 }") {
  return fmt::format(
      "camera {{ orthographic location -5*z direction z right .001*x up .001*y }} background {{ rgb <.8, .4, .2> }} "
      "plane {{ -z, 0 {} {} }} ",
      textures, finish);
}

std::string pigment(const std::string& image, const char* place) {
  return fmt::format("pigment {{ image_map {{ function {} }} translate -<{}> }} ", image, place);
}

/// Its pixels are 0 and .3 above .2 and .5.
constexpr const char* kFour = "2, 2 { .3*x + .2*y }";

TEST(Images, of_functions_begin_at_the_upper_left) {
  expect_middle(sheet(pigment(kFour, ".2, .7, 0")), 0, 0, 0);
  expect_middle(sheet(pigment(kFour, ".7, .7, 0")), .3, .3, .3);
  expect_middle(sheet(pigment(kFour, ".2, .2, 0")), .2, .2, .2);
  expect_middle(sheet(pigment(kFour, "1.7, -.7, 0")), .5, .5, .5);
}

TEST(Images, are_interpolated_between_pixels) {
  expect_middle(sheet(pigment("2, 2 { .3*x + .2*y } interpolate 2", ".5, .5, 0")), .25, .25, .25);
}

TEST(Images, let_light_through_as_they_say) {
  expect_middle(sheet(pigment("2, 2 { .5 } transmit all .5 ", ".2, .2, 0")), .25 + .4, .25 + .2, .25 + .1);
  expect_middle(sheet(pigment("2, 2 { .5 } filter all .5 ", ".2, .2, 0")), .25 + .2, .25 + .1, .25 + .05);
}

TEST(Images, that_are_mapped_once_are_clear_around_it) {
  expect_middle(sheet(pigment("2, 2 { .5 } once", "-1, .2, 0")), .8, .4, .2);
  // A layer below shows, too.
  expect_middle(sheet("texture { pigment { rgb <.1, .2, .3> } finish { ambient 1 diffuse 0 } } texture { " +
                      pigment("2, 2 { .5 } once", "-1, .2, 0") + "}"),
                .1, .2, .3);
}

TEST(Images, choose_colours_of_maps_and_textures) {
  const auto chosen = [](const char* place) {
    return sheet(fmt::format(
        "pigment {{ image_pattern {{ function {} }} color_map {{ [0 rgb x] [1 rgb y] }} translate -<{}> }} ", kFour,
        place));
  };
  expect_middle(chosen(".2, .2, 0"), .8, .2, 0);
  const auto material = [](const char* place) {
    return sheet(fmt::format("texture {{ material_map {{ function 2, 1 {{ 1.5*x/255 }} "
                             "texture {{ pigment {{ rgb <.1, .2, .3> }} finish {{ ambient 1 diffuse 0 }} }} "
                             "texture {{ pigment {{ rgb <.4, .5, .6> }} finish {{ ambient 1 diffuse 0 }} }} }} "
                             "translate -<{}> }} ",
                             place),
                 "");
  };
  expect_middle(material(".2, .2, 0"), .1, .2, .3);
  expect_middle(material(".7, .2, 0"), .4, .5, .6);
}

TEST(Images, bend_normals_towards_lower_pixels) {
  // Heights of 0, .3 and .6 from left to right: at the middle pixel, of the triangle that it makes with its lower
  // neighbours, the slope is .3 a pixel along x and 0 along y. The light comes from the left, where the surface turns.
  const double size = 1.5, slope = size * .3, angle = .5;
  const std::string scene =
      "camera { orthographic location -5*z direction z right .001*x up .001*y } " +
      light_at(-angle * 180 / std::acos(-1.)) +
      fmt::format(
          "plane {{ -z, 0 pigment {{ rgb 1 }} normal {{ bump_map {{ function 3, 3 {{ .6*x }} bump_size {} }} "
          "translate -<.5, .5, 0> }} finish {{ ambient 0 diffuse 1 }} }} ",
          size);
  const double light = (std::sin(angle) * slope + std::cos(angle)) / std::sqrt(1 + slope * slope);
  expect_middle(scene, light, light, light);
}

TEST(Images, bend_the_rays_of_cameras) {
  // Heights grow by .3 a pixel: over 5 units of depth, the ray moves by 1.5 of 20.
  const auto seen = [](const char* normal) {
    const std::string scene = fmt::format(
        "{}camera {{ location -5*z direction z right .001*x up .001*y {} }} "
        "plane {{ -z, 0 pigment {{ gradient x color_map {{ [0 rgb 0] [1 rgb 1] }} scale 20 translate -10*x }} "
        "finish {{ ambient 1 diffuse 0 }} }} ",
        kHead, normal);
    return middle_of(rendered(scene).image).x;
  };
  EXPECT_NEAR(seen(""), .5, 1e-4);
  EXPECT_NEAR(seen("normal { bump_map { function 3, 3 { .6*x } bump_size 1 } translate -<.5, .5, 0> }"), .575, 1e-4);
}

TEST(Images, are_seen_by_functions) {
  expect_middle(
      sheet("pigment { function { pattern { image_pattern { function 2, 2 { .3*x + .2*y } } translate -.2*x } } "
            "color_map { [0 rgb 0] [1 rgb 1] } translate -.7*y } "),
      0, 0, 0);
  expect_middle(
      sheet("pigment { function { pattern { image_pattern { function 2, 2 { .3*x + .2*y } } translate -.7*x } } "
            "color_map { [0 rgb 0] [1 rgb 1] } translate -.2*y } "),
      .5, .5, .5);
}

TEST(Images, are_an_effect_that_may_be_left_out) {
  const std::string scene = kHead + sheet(pigment(kFour, ".7, .7, 0"));
  const render::RenderResult with = rendered(scene);
  EXPECT_TRUE(with.statistics.plan.has("images"));
  const render::RenderResult without = [&] {
    render::RenderOptions options;
    options.without = {"images"};
    return rendered(scene, 17, options);
  }();
  EXPECT_FALSE(without.statistics.plan.has("images"));
  EXPECT_NEAR(middle_of(without.image).x, .5, 1e-6);
}

TEST(Images, that_are_opaque_do_not_call_for_transparency) {
  const auto has_transparency = [](const char* image) {
    return rendered(kHead + sheet(pigment(image, ".2, .2, 0"))).statistics.plan.has("transparency");
  };
  EXPECT_FALSE(has_transparency("2, 2 { .5 }"));
  EXPECT_TRUE(has_transparency("2, 2 { .5 } once"));
  EXPECT_TRUE(has_transparency("2, 2 { .5 } transmit all .1"));
}

}  // namespace
}  // namespace isl::test
