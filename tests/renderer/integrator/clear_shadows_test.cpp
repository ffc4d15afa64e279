// Shadows of objects that let light through, wherever in an object the texture is said that does.
#include "tests/renderer/integrator/middle_pixel.h"

#include <cmath>

namespace isl::test {
namespace {

/// The middle of a white floor that is lit at 45 degrees, past what lies on the way at <2, 0, -2>.
void expect_share(const std::string& on_the_way, double share) {
  const double light = std::sqrt(.5) * share;
  expect_middle(std::string(kStraight) + light_at(45) +
                    "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } " + on_the_way,
                light, light, light);
}

std::string ball(const std::string& more) { return "sphere { <2, 0, -2>, .3 " + more + " } "; }

const std::string kHalfClear = "pigment { rgbt <0, 0, 0, .5> } ", kOpaque = "pigment { rgb 0 } ",
                  kAllClear = "pigment { rgbt 1 } ";

TEST(ClearShadows, are_filtered_by_both_faces) {
  expect_share("", 1);
  expect_share(ball(kOpaque), 0);
  expect_share(ball(kHalfClear), .25);
  expect_share(ball("pigment { rgbf <.5, .5, .5, 1> } "), .25);
  expect_share("#default { " + kHalfClear + "} sphere { <2, 0, -2>, .3 } ", .25);
}

TEST(ClearShadows, need_the_lowest_layer) {
  expect_share(ball("texture { " + kHalfClear + "} texture { " + kHalfClear + "} "), .0625);
  expect_share(ball("texture { " + kOpaque + "} texture { " + kHalfClear + "} "), 0);
}

TEST(ClearShadows, may_come_from_any_entry_of_a_map) {
  expect_share(ball("texture { average texture_map { [1 " + kOpaque + "] [1 " + kAllClear + "] } } "), .25);
  expect_share(ball("pigment { average pigment_map { [1 rgb 0] [1 rgbt 1] } } "), .25);
  expect_share(ball("pigment { checker rgbt <0, 0, 0, .5>, rgbt <0, 0, 0, .5> } "), .25);
  expect_share(ball("pigment { checker rgb 0, rgb 1 } "), 0);
}

TEST(ClearShadows, may_come_from_a_part_or_from_the_whole) {
  const std::string plain = ball(""), half = ball(kHalfClear), far = "box { 5, 6 } ";
  expect_share("union { " + plain + far + kHalfClear + "} ", .25);
  expect_share("union { " + half + far + kOpaque + "} ", .25);
  expect_share("difference { " + half + far + "} ", .25);
  expect_share("difference { " + plain + far + kHalfClear + "} ", .25);
  expect_share("intersection { " + ball(kOpaque) + "box { -9, 9 " + kHalfClear + "} } ", 0);
  expect_share("blob { threshold .5 sphere { <2, 0, -2>, .5, 1 " + kHalfClear + "} } ", .25);
  expect_share("blob { threshold .5 sphere { <2, 0, -2>, .5, 1 } " + kHalfClear + "} ", .25);
  expect_share("intersection { blob { threshold .5 sphere { <2, 0, -2>, .5, 1 " + kHalfClear + "} } box { -9, 9 } } ",
               .25);
  expect_share(ball(kHalfClear + "interior_texture { " + kOpaque + "} "), 0);
}

TEST(ClearShadows, are_dark_where_something_opaque_lies_before_or_beyond) {
  const std::string before = "sphere { <1, 0, -1>, .3 " + kOpaque, beyond = "sphere { <3, 0, -3>, .3 " + kOpaque;
  expect_share(ball(kHalfClear) + before + "} ", 0);
  expect_share(ball(kHalfClear) + beyond + "} ", 0);
  expect_share(ball(kHalfClear) + beyond + "no_shadow } ", .25);
  expect_share(ball(kHalfClear + "no_shadow "), 1);
}

}  // namespace
}  // namespace isl::test
