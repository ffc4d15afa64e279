// The gamma of a scene follows from the versions that its files state, and changes where they state them. The pixels
// are those of POV-Ray 3.7's pictures of the same scenes, whose only colours are the sphere's own.
#include "tests/cli/program/ppm_values.h"
#include "tests/cli/program/program_fixture.h"

#include <cmath>

namespace isl::test {
namespace {

constexpr std::string_view kSphere =
    "camera { location -5*z right x }\nsphere { 0, 1 pigment { rgb <0.4, 0.2, 0.8> } finish { ambient 1 diffuse 0 } "
    "}\n";
/// A library that states the version it was written in, and then restores the previous one.
constexpr std::string_view kLibrary = "#declare Before = version;\n#version 3.5;\n#version Before;\n";

class Gamma : public ProgramTest {
 protected:
  /// The middle pixel of 3 by 3, in steps of 255.
  std::string pixel(const std::string& name, std::string_view text) const {
    write("library.inc", kLibrary);
    write(name, text);
    const ProcessResult result = run({"render", name, "-s", "3x3", "--samples", "1", "-q", "-o", "out.ppm"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::vector<double> values = ppm_values(read("out.ppm"));
    if (values.size() != 27) return "no picture";
    std::string shown;
    for (std::size_t i = 12; i < 15; ++i) shown += std::to_string(std::lround(values[i] * 255)) + " ";
    return shown;
  }
  static std::string with(std::string_view before, std::string_view after = "") {
    return std::string(before) + std::string(kSphere) + std::string(after);
  }

  const std::string off = "102 51 204 ", linear = "170 124 231 ";
};

TEST_F(Gamma, IsOffWhereNoFileStatesAVersion) {
  EXPECT_EQ(pixel("a.pov", with("")), off);
  EXPECT_EQ(pixel("A.POV", with("")), off);
  EXPECT_EQ(pixel("a.pov", with("#if (version < 3.7) #version 3.7; #end\n")), off)
      << "a statement that is not executed does not count";
}

TEST_F(Gamma, IsLinearWhereOurOwnFilesStateNone) { EXPECT_EQ(pixel("a.isl", with("")), linear); }

TEST_F(Gamma, IsThatOfTheVersionInForceAtTheEnd) {
  EXPECT_EQ(pixel("a.pov", with("#version 3.6;\n")), off);
  EXPECT_EQ(pixel("a.pov", with("#version 3.7;\n")), linear);
  EXPECT_EQ(pixel("a.pov", with("#version 3.6;\n", "#version 3.7;\n")), linear);
  EXPECT_EQ(pixel("a.pov", with("#version 3.7;\n", "#version 3.6;\n")), off);
  EXPECT_EQ(pixel("a.pov", with("", "#version version;\n")), linear);
}

TEST_F(Gamma, IsThatOfAVersionThatAnIncludeFilePutsBack) {
  EXPECT_EQ(pixel("a.pov", with("#include \"library.inc\"\n")), linear);
  EXPECT_EQ(pixel("a.pov", with("", "#include \"library.inc\"\n")), linear) << "behind the objects";
  EXPECT_EQ(pixel("a.pov", with("#version 3.6;\n#include \"library.inc\"\n")), off);
}

TEST_F(Gamma, IsLinearWithOurOwnStandardFiles) {
  for (const std::string name : {"colors", "consts", "math", "rand", "transforms"})
    EXPECT_EQ(pixel("a.pov", with("#include \"" + name + ".inc\"\n")), linear) << name;
}

TEST_F(Gamma, IsWhatTheSceneSaysWhateverItsVersion) {
  for (const std::string before : {"", "#version 3.6;\n", "#version 3.7;\n", "#include \"library.inc\"\n"}) {
    EXPECT_EQ(pixel("a.pov", with(before + "global_settings { assumed_gamma 1 }\n")), linear) << before;
    EXPECT_EQ(pixel("a.pov", with(before, "global_settings { assumed_gamma srgb }\n")), off) << before;
  }
}

}  // namespace
}  // namespace isl::test
