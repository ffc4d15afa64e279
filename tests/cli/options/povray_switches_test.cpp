#include "cli/options/povray_switches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace isl::cli {
namespace {

std::string equivalent(const std::vector<std::string>& arguments) {
  const auto found = find_povray_switches(arguments);
  return found ? found->equivalent : "none";
}

TEST(PovraySwitches, AreTranslatedTogether) {
  EXPECT_EQ(equivalent({"+Iscene.pov", "+W640", "+H480", "+A0.2", "+Q4"}),
            "isl render scene.pov -s 640x480 --aa 0.2 --quality 4");
  EXPECT_EQ(equivalent({"render", "scene.isl", "+W640"}), "isl render scene.isl -s 640x600");
  EXPECT_EQ(equivalent({"Input_File_Name=a.pov", "Width=320", "Height=200", "Declare=N=3"}),
            "isl render a.pov -s 320x200 -D N=3");
  EXPECT_EQ(equivalent({"+ia.pov", "+ob.exr", "+ua", "+wt2", "-A"}),
            "isl render a.pov -o b.exr --alpha -t 2 --samples 1");
  EXPECT_EQ(equivalent({"+Ia.pov", "+SC10", "+EC20"}), "isl render a.pov --crop X0,Y0,X1,Y1");
}

TEST(PovraySwitches, WithoutACounterpartAreNamed) {
  const std::vector<std::string> arguments{"+Ia.pov", "-V", "+P", "+R3"};
  const auto found = find_povray_switches(arguments);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->ignored, "-V +P +R3");
}

TEST(PovraySwitches, AreNotSeenInOurOwnOptions) {
  EXPECT_EQ(equivalent({"render", "a.isl", "-D", "Width=640", "-I", "lib", "--clock=1", "-t", "2", "-o", "x.png"}),
            "none");
  EXPECT_EQ(equivalent({"check", "-"}), "none");
}

}  // namespace
}  // namespace isl::cli
