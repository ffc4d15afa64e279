// Clear bodies that share faces, in whole pictures: they look as with a gap that is too narrow to be seen, whichever is
// declared first. (The limit of a gap is what POV-Ray 3.7 shows: <177, 212, 169> of 255 in the middle of the boxes.)
#include "tests/renderer/integrator/middle_pixel.h"

#include <cmath>

namespace isl::test {
namespace {

constexpr const char* kMaterials =
    "#declare Clear = finish { ambient 0 diffuse 0 }; "
    "#macro Glass() pigment { rgbt 1 } finish { Clear } interior { ior 1.5 fade_distance 1 fade_power 1000 fade_color "
    "<.5, .9, .9> } #end "
    "#macro Drink() pigment { rgbt 1 } finish { Clear } interior { ior 1.33 fade_distance 1 fade_power 1000 "
    "fade_color <.9, .9, .4> } #end "
    "#macro Ice() pigment { rgbt 1 } finish { Clear } interior { ior 1.2 fade_distance 1 fade_power 1000 "
    "fade_color <.7, .5, .9> } #end ";
constexpr const char* kParallelView =
    "camera { orthographic location -10*z look_at 0 right 4*x up 4*y } background { rgb .8 } ";
/// The bodies A and B in either order, turned together.
constexpr const char* kBoth =
    "union { #if (Swapped) object { B } object { A } #else object { A } object { B } #end "
    "rotate Turn*<.3, 1, .1> translate <.1, .03, .7> } ";

struct Setting {
  bool swapped = false;
  double gap = 0, turn = 0;
};

constexpr int kSize = 61;

render::Image picture_of(const std::string& scene, const Setting& setting) {
  render::RenderOptions options;
  options.samples = 1;
  return rendered(
             fmt::format("#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 30 }} #declare Gap = {}; "
                         "#declare Swapped = {}; #declare Turn = {}; {}{}",
                         setting.gap, setting.swapped ? 1 : 0, setting.turn, kMaterials, scene),
             kSize, options)
      .image;
}

/// The number of pixels that differ by more than a code of eight bits.
int differing(const render::Image& a, const render::Image& b) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    bool differs = false;
    for (std::size_t i = 0; i < 3; ++i) differs |= !(std::abs(a.rgba[pixel + i] - b.rgba[pixel + i]) < 1.0 / 255);
    count += differs ? 1 : 0;
  }
  return count;
}

/// Expects the picture of the limit of a gap. `edges` is the number of pixels that a gap, which is wider than rounding,
/// may change.
void expect_as_with_a_gap(const std::string& scene, double turn = 0, int edges = 8) {
  constexpr double kGap = 1e-7;
  const render::Image with_gap = picture_of(scene, {false, kGap, turn});
  EXPECT_LE(differing(picture_of(scene, {false, 0, turn}), with_gap), edges) << turn << " " << scene;
  EXPECT_LE(differing(picture_of(scene, {true, 0, turn}), with_gap), edges) << "swapped, " << turn << " " << scene;
}

constexpr double kTurns[] = {0, 1, 30, 45, 77, 90};

const std::string kBoxes = std::string(kParallelView) +
                           "#declare A = box { -1, <1, 1, 0> Glass() }; "
                           "#declare B = box { <-1, -1, Gap>, 1 Drink() }; ";

TEST(TouchingBodies, both_colour_the_light) {
  for (const double turn : kTurns) expect_as_with_a_gap(kBoxes + kBoth, turn);
  const render::Rgb middle = middle_of(picture_of(kBoxes + kBoth, {}));
  const auto display = [](double code) { return std::pow((code / 255 + .055) / 1.055, 2.4); };
  EXPECT_NEAR(middle.x, display(177), .004);
  EXPECT_NEAR(middle.y, display(212), .004);
  EXPECT_NEAR(middle.z, display(169), .004);
}

TEST(TouchingBodies, may_be_round) {
  const std::string balls = std::string(kParallelView) +
                            "#declare A = difference { sphere { 0, 1.2 } sphere { 0, .8 } Glass() }; "
                            "#declare B = sphere { 0, .8 - Gap Drink() }; ";
  const std::string glass = std::string(kParallelView) +
                            "#declare A = difference { cylinder { -y, 1.1*y, 1 } cylinder { -.8*y, 1.2*y, .8 } "
                            "Glass() }; #declare B = cylinder { (Gap - .8)*y, .6*y, .8 - Gap Drink() }; ";
  for (const double turn : kTurns) {
    expect_as_with_a_gap(balls + kBoth, turn);
    expect_as_with_a_gap(glass + kBoth, turn);
  }
}

TEST(TouchingBodies, may_be_blobs) {
  const std::string blobs =
      std::string(kParallelView) +
      "#declare A = difference { box { -1.2, 1.2 } blob { threshold .3 sphere { -.3*x, 1.2, 1 } sphere { .4*x, 1, 1 } "
      "} Glass() }; #declare B = blob { threshold .3 + Gap sphere { -.3*x, 1.2, 1 } sphere { .4*x, 1, 1 } Drink() }; ";
  for (const double turn : {0.0, 30.0, 77.0}) expect_as_with_a_gap(blobs + kBoth, turn);
}

TEST(TouchingBodies, may_be_several_and_share_a_part_of_a_face) {
  const std::string three = std::string(kParallelView) +
                            "#declare A = box { -1, <1, 1, 0> Glass() }; "
                            "#declare B = union { box { <-1, -1, Gap>, <0, .5, 1> Drink() } "
                            "box { <Gap, -.8, Gap>, <1, 1, 1.5> Ice() } }; ";
  for (const double turn : kTurns) expect_as_with_a_gap(three + kBoth, turn, 40);
}

TEST(TouchingBodies, may_be_parts_of_a_combination) {
  const std::string cut =
      kBoxes + "intersection { " + kBoth + "sphere { .7*z, 1.4 pigment { rgbt 1 } finish { Clear } } }";
  EXPECT_LE(differing(picture_of(cut, {}), picture_of(cut, {false, 1e-7, 0})), 8);
  EXPECT_LE(differing(picture_of(cut, {false, 0, 30}), picture_of(cut, {false, 1e-7, 30})), 8);
}

TEST(TouchingBodies, mirror_and_throw_shadows) {
  const std::string scene =
      "camera { location <1, 2.5, -5> look_at .3*y angle 35 } light_source { <4, 8, -3> rgb 1 } "
      "sky_sphere { pigment { gradient y color_map { [0 rgb .6] [1 rgb <.2, .4, 1>] } } } "
      "plane { y, -1 pigment { checker rgb 1 rgb .4 } } "
      "#declare Clear = finish { ambient 0 diffuse .1 reflection { .02, 1 fresnel } conserve_energy }; "
      "#declare A = box { -1, <1, 1, 0> Glass() }; #declare B = box { <-1, -1, Gap>, 1 Drink() }; ";
  for (const double turn : {0.0, 30.0}) expect_as_with_a_gap(scene + kBoth, turn, 40);
}

/// Nothing is reflected totally where glass stands on a table, as in POV-Ray.
TEST(TouchingBodies, see_what_is_opaque_as_if_they_reached_into_it) {
  const std::string scene =
      "camera { location <1, 2.5, -5> look_at .3*y angle 35 } light_source { <4, 8, -3> rgb 1 } background { rgb .8 } "
      "box { <-9, -1, -9>, <9, -Gap, 9> pigment { checker rgb 1 rgb .6 translate .5*y } } "
      "box { <-.7, 0, -.7>, <.7, .8, .7> Glass() rotate 20*y }";
  const render::Image contact = picture_of(scene, {});
  EXPECT_LE(differing(contact, picture_of(scene, {.gap = -1e-7})), 40);
  EXPECT_GT(differing(contact, picture_of(scene, {.gap = 1e-7})), 100);
}

}  // namespace
}  // namespace isl::test
