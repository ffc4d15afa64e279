// Effects that are read but not drawn yet are an error of `isl render` and `isl check` at their place, and a warning
// with --lenient.
#include "tests/cli/program/program_fixture.h"

namespace isl::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kScene = R"(camera { location -4*z }
sphere { 3*x, 1 texture { pigment { rgb 1 } normal { density_file df3 "one.df3" 0.5 } } }
#macro Ball(X) sphere { X*x, 1 pigment { density_file df3 "one.df3" } } #end
light_source { <0, 0, -9>, rgb 1 }
Ball(0) Ball(6)
)";

/// A density of one voxel: three sizes of two bytes, and its value.
constexpr std::string_view kDensity("\0\1\0\1\0\1\200", 7);

class Unrendered : public ProgramTest {
 protected:
  Unrendered() {
    write("one.df3", kDensity);
    write("scene.isl", kScene);
  }
};

TEST_F(Unrendered, IsAnErrorOfRenderAtItsPlace) {
  const ProcessResult result = run({"render", "scene.isl", "-s", "32x24"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("scene.isl:2:54: error: a `normal` that depends on a density file is not rendered yet"));
  EXPECT_THAT(result.err,
              HasSubstr("scene.isl:3:42: error: a pigment that depends on a density file is not rendered yet"));
  EXPECT_THAT(result.err, HasSubstr("2 times in the scene, this is the first; `--lenient` leaves it out"));
  EXPECT_THAT(result.err, HasSubstr("Ball"));
  EXPECT_FALSE(exists("scene.png"));
}

TEST_F(Unrendered, IsLeftOutWithAWarningWhereTheUserIsLenient) {
  const ProcessResult result = run({"render", "scene.isl", "-s", "32x24", "--lenient"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("warning: a pigment that depends on a density file is not rendered yet; left out"));
  EXPECT_TRUE(exists("scene.png"));
}

TEST_F(Unrendered, IsToldByCheckInTheSameWords) {
  const ProcessResult result = run({"check", "scene.isl"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, run({"render", "scene.isl", "-s", "32x24"}).err);
}

TEST_F(Unrendered, IsNoMatterWhereItIsLeftOut) {
  const ProcessResult result = run({"check", "scene.isl", "--without", "pigment_by_file,normal_by_file"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("rendered")));
  EXPECT_THAT(result.out, HasSubstr("3 primitives, 3 solids, 1 light"));
  EXPECT_THAT(result.out, HasSubstr("bounding box: <-1, -1, -1> to <7, 1, 1>"));
}

TEST_F(Unrendered, StopsADumpOfTheGridAndNoOther) {
  EXPECT_EQ(run({"dump", "scene.isl", "--stage", "grid"}).exit_code, 1);
  EXPECT_EQ(run({"dump", "scene.isl", "--stage", "grid", "--lenient"}).exit_code, 0);
  EXPECT_EQ(run({"dump", "scene.isl", "--stage", "database"}).exit_code, 0);
}

TEST_F(Unrendered, AWrongSolverOrToleranceIsToldAtItsPlace) {
  write("wrong.isl", "sphere { 0, 1 }\nglobal_settings {\n  solver \"hermit\"\n  tolerance \"1mm\" }\n");
  const ProcessResult result = run({"check", "wrong.isl"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("wrong.isl:3:10: error: global_settings: "));
  EXPECT_THAT(result.err, HasSubstr("wrong.isl:4:3: error: global_settings: "));
}

}  // namespace
}  // namespace isl::test
