// `isl check` and `isl dump`, and the behaviour that all commands share.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class CheckCommand : public ProgramTest {};

TEST_F(CheckCommand, TraceTellsWhetherItsAnswerIsCertain) {
  // The second ray runs in the surface of a cylinder, where the field equals the threshold, (1 - 1/4)^2.
  write("certain.isl",
        "#declare C = 7; #declare N = <0, 0, 0>;\n"
        "#declare P = trace(sphere { 0, 1 }, -5*z, z, N, C);\n"
        "#debug concat(str(C, 0, 0), \" \")\n"
        "#declare B = blob { threshold 0.5625 cylinder { -z, z, 2, 1 } };\n"
        "#declare P = trace(B, x - 5*z, z, N, C);\n"
        "#debug concat(str(C, 0, 0), \"\\n\")\n");
  const ProcessResult result = run({"check", "certain.isl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("1 0\n"));
}

TEST_F(CheckCommand, TellsWhatTheSceneHoldsAndWhereToLookFrom) {
  write("a.isl", kSmallScene);
  const ProcessResult result = run({"check", "a.isl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("1 primitive, 1 solid, 1 light"));
  EXPECT_THAT(result.out, HasSubstr("bounding box: <-1, -1, -1> to <1, 1, 1>"));
}

TEST_F(CheckCommand, ItsCameraSeesTheScene) {
  // The scene's own camera looks away; with the suggested camera, the warning must not appear.
  const std::string objects = "light_source { 9, 1 }\nblob { threshold 0.5 sphere { <30, 5, 2>, 3, 1 } }\n";
  write("a.isl", "camera { location <0, 0, -5> look_at <0, 0, -9> }\n" + objects);
  const ProcessResult blind = run({"check", "a.isl"});
  EXPECT_THAT(blind.err, HasSubstr("the camera sees nothing"));
  const std::size_t begin = blind.out.find("camera {");
  ASSERT_NE(begin, std::string::npos) << blind.out;
  write("b.isl", blind.out.substr(begin, blind.out.find('\n', begin) - begin) + "\n" + objects);
  const ProcessResult seeing = run({"check", "b.isl"});
  EXPECT_EQ(seeing.exit_code, 0);
  EXPECT_EQ(seeing.err, "");
}

TEST_F(CheckCommand, NamesWhatIsTooShortToHaveASurfaceByItself) {
  write("a.isl",
        "light_source { 9, 1 }\nblob { kernel \"quartic\" convolution on\n  cylinder { 0, 9 * x, 0.3 }\n"
        "  #for (I, 0, 9) cylinder { I * x / 200, (I + 1) * x / 200, 0.3 } #end\n  torus { 0.001, 0.4 }\n}\n");
  const ProcessResult result = run({"check", "a.isl"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("a.isl:4:18: warning: this `cylinder` is too short to have a surface by itself: "
                                    "convolved, it reaches 0.134 of the threshold"));
  EXPECT_THAT(result.err, HasSubstr("11 components have none, this is the first"));
}

TEST_F(CheckCommand, ReadsStandardInput) {
  const ProcessResult result = run({"check", "-"}, {.input = std::string(kSmallScene)});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("standard input: 1 primitive"));
}

TEST_F(CheckCommand, SetsVariablesBeforeTheFirstLine) {
  write("a.isl", "#ifndef (N) #declare N = 1; #end\nlight_source { 9, 1 }\n#for (I, 1, N) sphere { I, 1 } #end\n");
  EXPECT_THAT(run({"check", "a.isl"}).out, HasSubstr("1 primitive,"));
  EXPECT_THAT(run({"check", "a.isl", "-D", "N=3"}).out, HasSubstr("3 primitives,"));
}

TEST_F(CheckCommand, FindsIncludesInTheOrderOfTheManual) {
  write("a.isl", "#include \"n.inc\"\nlight_source { 9, 1 }\n#for (I, 1, N) sphere { I, 1 } #end\n");
  EXPECT_EQ(run({"check", "a.isl"}).exit_code, 1);
  write("path/n.inc", "#declare N = 4;\n");
  setenv("ISL_PATH", (folder() / "path").c_str(), 1);
  EXPECT_THAT(run({"check", "a.isl"}).out, HasSubstr("4 primitives,"));
  write("option/n.inc", "#declare N = 3;\n");
  EXPECT_THAT(run({"check", "a.isl", "-I", "option"}).out, HasSubstr("3 primitives,")) << "-I comes before ISL_PATH";
  unsetenv("ISL_PATH");
  write("n.inc", "#declare N = 2;\n");
  EXPECT_THAT(run({"check", "a.isl", "-I", "option"}).out, HasSubstr("2 primitives,"))
      << "the scene's folder comes first";
}

TEST_F(CheckCommand, AnswersInJson) {
  write("a.isl", kSmallScene);
  const json document = json::parse(run({"check", "a.isl", "--format", "json"}).out);
  EXPECT_EQ(document["diagnostics"].size(), 0u);
  EXPECT_EQ(document["scene"]["primitives"], 1);
  EXPECT_EQ(document["bounding_box"]["max"], json({1.0, 1.0, 1.0}));
  EXPECT_THAT(document["camera"].get<std::string>(), HasSubstr("look_at"));
}

TEST_F(CheckCommand, TellsProblemsInJson) {
  write("a.isl", "sphere { 0, Raduis }\n");
  const ProcessResult result = run({"check", "a.isl", "--format", "json"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  const json problem = json::parse(result.out).at("diagnostics").at(0);
  EXPECT_EQ(problem.at("severity"), "error");
  EXPECT_THAT(problem.at("message").get<std::string>(), HasSubstr("Raduis"));
}

TEST_F(CheckCommand, NeverLoadsTheImageLibraries) {
  // Loading them at the start would cost hundreds of milliseconds. The least time of several runs is what the program
  // itself needs.
  write("a.isl", kSmallScene);
  write("show_maps.sh", "#!/bin/sh\nLD_DEBUG=files exec \"$@\"\n");
  const ProcessResult result = run_process(
      {"/bin/sh", (folder() / "show_maps.sh").string(), ISL_PROGRAM, "check", (folder() / "a.isl").string()});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("libc.so")) << "the loader's own account is missing";
  EXPECT_THAT(result.err, testing::Not(HasSubstr("OpenImageIO")));
}

TEST_F(CheckCommand, DumpsEveryStage) {
  write("a.isl", kSmallScene);
  for (const char* stage : {"tokens", "ast", "database", "grid"}) {
    const ProcessResult result = run({"dump", "a.isl", "--stage", stage});
    EXPECT_EQ(result.exit_code, 0) << stage << result.err;
    EXPECT_FALSE(result.out.empty()) << stage;
    EXPECT_EQ(run({"dump", "a.isl", "--stage", stage}).out, result.out) << stage << ": twice the same";
  }
  EXPECT_THAT(run({"dump", "a.isl", "--stage", "tokens"}).out, HasSubstr("sphere"));
  EXPECT_THAT(run({"dump", "a.isl", "--stage", "ast"}).out, HasSubstr("sphere"));
  const json database = json::parse(run({"dump", "a.isl", "--stage", "database"}).out);
  EXPECT_EQ(database.at("solids").size(), 1u);
}

TEST_F(CheckCommand, AnswersPovraysSwitchesWithOurs) {
  const ProcessResult result = run({"render", "a.pov", "+W640", "+H480", "+A0.3"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("isl render a.pov -s 640x480 --aa 0.3"));
}

TEST_F(CheckCommand, HelpAndVersionSucceedAndMistakesDoNot) {
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  EXPECT_THAT(run({"--version"}).out, testing::MatchesRegex("isl [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_EQ(run({}).exit_code, 2);
  EXPECT_EQ(run({"frobnicate"}).exit_code, 2);
}

}  // namespace
}  // namespace isl::test
