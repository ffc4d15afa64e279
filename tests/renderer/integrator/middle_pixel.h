// Scenes whose middle pixel is compared: with the middle of POV-Ray 3.7's pictures (assumed_gamma 1, linear values,
// five digits) and with closed forms.
#pragma once

#include "tests/renderer/integrator/rendered_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace isl::test {

inline constexpr const char* kHead = "#version 3.7; global_settings { assumed_gamma 1 } ";
/// Cameras that look through the origin: straight on, and at 60 degrees to the normal of z = 0.
inline constexpr const char* kStraight = "camera { location -5*z direction z right x up y } ";
inline constexpr const char* kAt60 = "camera { location -5*<.8660254037844387, 0, .5> look_at 0 right x up y } ";
inline constexpr const char* kBackground = "background { rgb <.8, .4, .2> } ";

inline std::string plane(const std::string& finish, const char* colour = "<.2, .4, .6>") {
  return fmt::format("plane {{ -z, 0 pigment {{ rgb {} }} finish {{ ambient 0 diffuse 0 {} }} }} ", colour, finish);
}

/// A light far away, at an angle to the normal of z = 0.
inline std::string light_at(double degrees) {
  const double a = degrees * std::acos(-1.0) / 180;
  return fmt::format("light_source {{ 1e6*<{}, 0, {}> rgb 1 }} ", std::sin(a), -std::cos(a));
}

inline void expect_middle(const std::string& scene, double red, double green, double blue, double tolerance = 2.5e-5) {
  const render::Rgb colour = middle_of(rendered(kHead + scene).image);
  EXPECT_NEAR(colour.x, red, tolerance) << scene;
  EXPECT_NEAR(colour.y, green, tolerance) << scene;
  EXPECT_NEAR(colour.z, blue, tolerance) << scene;
}

}  // namespace isl::test
