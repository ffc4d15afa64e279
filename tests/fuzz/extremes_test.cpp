// Objects of sizes and at places that no scene needs, drawn among others: squares of such numbers overflow or vanish.
#include "tests/fuzz/hostile_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isl::test {
namespace {

constexpr const char* kExtremes[] = {"1e-320", "1e-160", "1e-30", "1e30",   "1e154",
                                     "1e155",  "1e200",  "8e307", "1.7e308"};

/// `{0}` is the number. Four small objects stand beside each, so that space has to be divided.
constexpr const char* kObjects[] = {
    "sphere {{ 0, {0} }}",
    "sphere {{ {0}, 1 }}",
    "sphere {{ 0, 1 scale {0} }}",
    "sphere {{ 0, 1 scale <1, {0}, 1> }}",
    "sphere {{ 0, 1 translate {0} }}",
    "sphere {{ 0, {0} scale {0} translate {0} }}",
    "box {{ -{0}, {0} }}",
    "box {{ 0, {0} rotate 45 }}",
    "cylinder {{ 0, {0}*y, {0} }}",
    "cone {{ 0, {0}, y, 1 }}",
    "torus {{ {0}, 1 }}",
    "torus {{ 1, {0} }}",
    "torus {{ {0}, 1.2*{0} }}",
    "ovus {{ {0}, 1 }}",
    "ovus {{ 1, {0} }}",
    "ovus {{ {0}, {0} }}",
    "plane {{ y, {0} }}",
    "plane {{ {0}*y, 1 }}",
    "disc {{ 0, y, {0} }}",
    "triangle {{ 0, {0}*x, {0}*y }}",
    "prism {{ 0, {0}, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }}",
    "prism {{ cubic_spline conic_sweep 0.5, 1, 6, <0, 0>, <1, 0>, <{0}, 1>, <0, 1>, <1, 0>, <0, 0> }}",
    "text {{ internal 1 \"a\" {0}, 0 }}",
    "text {{ internal 1 \"ab\" 1, {0}*z }}",
    "polygon {{ 4, 0, {0}*x, {0}*y, 0 }}",
    "superellipsoid {{ <{0}, 1> }}",
    "quadric {{ <{0}, 1, 1>, 0, 0, -1 }}",
    "quadric {{ <1, 1, 1>, 0, 0, -{0} }}",
    "quartic {{ <{0},0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> }}",
    "blob {{ sphere {{ 0, {0}, 2 }} }}",
    "blob {{ sphere {{ {0}, 1, 2 }} sphere {{ 0, 1, 2 }} }}",
    "blob {{ sphere {{ 0, 1, {0} }} }}",
    "blob {{ threshold {0} sphere {{ 0, 1, 2 }} }}",
    "blob {{ cylinder {{ 0, {0}*y, 1, 2 }} }}",
    "blob {{ sphere {{ 0, 1, 2 scale <1, {0}, 1> }} }}",
    "blob {{ sphere {{ 0, 1, 2 }} scale {0} }}",
    "blob {{ kernel \"gaussian\" sphere {{ 0, {0} }} box {{ 0, {0}, 1 }} }}",
    "blob {{ kernel \"cauchy\" convolution on cylinder {{ 0, {0}*y, 1 }} }}",
    "union {{ sphere {{ 0, {0} }} sphere {{ x, 1 }} }}",
    "intersection {{ sphere {{ 0, {0} }} plane {{ y, {0} }} }}",
    "difference {{ box {{ -{0}, {0} }} sphere {{ 0, 1 }} }}",
    "light_source {{ {0}, rgb {0} }}",
    "light_source {{ 0, rgb 1 fade_distance {0} fade_power {0} }}",
    "sphere {{ 0, 1 pigment {{ checker scale {0} }} }}",
    "sphere {{ 0, 1 pigment {{ bozo turbulence {0} scale {0} }} }}",
    "sphere {{ 0, 1 pigment {{ crackle translate {0} }} }}",
    "sphere {{ 0, 1 pigment {{ wood frequency {0} phase {0} }} }}",
    "sphere {{ 0, 1 normal {{ bumps {0} scale {0} }} }}",
    "sphere {{ 0, 1 finish {{ phong {0} phong_size {0} reflection {0} }} }}",
    "camera {{ location {0} look_at 1 }}",
    "camera {{ location 0 direction {0}*z }}",
    "camera {{ right {0}*x up {0}*y }}",
};

TEST(Extremes, AreDrawnOrRefused) {
  const std::string around = R"(#version 3.7;
light_source { <5, 5, -5>, rgb 1 }
sphere { 0, 0.1 } sphere { 0.1*x, 0.1 } sphere { 0.2*x, 0.1 } box { -0.1, 0.1 } blob { sphere { 0, 1, 2 } }
)";
  int accepted = 0, count = 0;
  for (const char* const object : kObjects) {
    for (const char* const number : kExtremes) {
      const std::string text = around + fmt::format(fmt::runtime(object), number);
      const SceneVerdict verdict = try_scene(text, {}, {}, /*lenient=*/true);
      EXPECT_EQ(verdict.trouble, "") << text;
      EXPECT_FALSE(verdict.is_slow) << text;
      accepted += verdict.is_accepted;
      ++count;
    }
  }
  EXPECT_GT(accepted, count / 2);
}

}  // namespace
}  // namespace isl::test
