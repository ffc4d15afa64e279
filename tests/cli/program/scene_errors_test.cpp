// Mistakes of users get a clear message and the right exit code, never a crash or a hang.
#include "tests/cli/program/program_fixture.h"

#include <sys/stat.h>

namespace isl::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class SceneErrors : public ProgramTest {
 protected:
  [[nodiscard]] ProcessResult check(std::string_view scene, std::vector<std::string> options = {}) const {
    write("scene.isl", scene);
    options.insert(options.begin(), {"check", "scene.isl"});
    return run(options);
  }
};

TEST_F(SceneErrors, AMissingFileIsAFileError) {
  const ProcessResult result = run({"check", "nowhere.isl"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("nowhere.isl"));
  EXPECT_EQ(run({"render", "nowhere.isl"}).exit_code, 3);
}

TEST_F(SceneErrors, AFolderOrAPipeIsNoScene) {
  std::filesystem::create_directory(folder() / "folder.isl");
  EXPECT_EQ(run({"check", "folder.isl"}).exit_code, 3);
  ASSERT_EQ(mkfifo((folder() / "pipe.isl").c_str(), 0600), 0);
  EXPECT_EQ(run({"check", "pipe.isl"}, {.limit = std::chrono::seconds(10)}).exit_code, 3)
      << "a pipe without a writer must not be waited for";
}

TEST_F(SceneErrors, AnEmptySceneIsReadAndRemarkedOn) {
  const ProcessResult result = check("");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("warning: scene.isl holds no object"));
}

TEST_F(SceneErrors, BinaryJunkIsOneError) {
  std::string junk;
  for (int i = 0; i < 20000; ++i) junk += static_cast<char>((i * 7919 + i / 256) & 0xFF);
  const ProcessResult result = check(junk);
  EXPECT_TRUE(result.exit_code == 1 || result.exit_code == 3) << result.exit_code;
  EXPECT_THAT(result.err, HasSubstr("scene.isl"));
  EXPECT_LT(result.err.size(), 2000u) << "one message, not one for each byte";
}

TEST_F(SceneErrors, AnUnclosedBlockNamesItsOpener) {
  const ProcessResult result = check("sphere {\n  0, 1\n  pigment { rgb 1 }\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("scene.isl:1:8"));
}

TEST_F(SceneErrors, ANameOfALibraryIsAnsweredWithItsFile) {
  std::filesystem::create_directory(folder() / "lib");
  write("lib/shapes_of_mine.inc", "#macro Wheel(R) torus { R, 0.1 } #end\n#declare Rubber = rgb 0.1;\n");
  const std::string hint = "is declared in `shapes_of_mine.inc`: write `#include \"shapes_of_mine.inc\"` before this";
  for (const char* const scene :
       {"object { Wheel(1) }", "Wheel(1)", "union { Wheel(1) }", "#declare W = Wheel(1);",
        "sphere { 0, 1 pigment { Rubber } }", "sphere { 0, 1 pigment { color Rubber } }", "#declare C = Rubber*2;",
        "Rubber { 1 }", "#declare F = function { Rubber }", "#declare F = function { Wheel(x) }"}) {
    const ProcessResult result = check(scene, {"-I", "lib"});
    EXPECT_EQ(result.exit_code, 1) << scene;
    EXPECT_THAT(result.err, HasSubstr(hint)) << scene;
  }
  EXPECT_THAT(check("sphere { 0, 1 pigment { Rubber } }").err, testing::Not(HasSubstr("shapes_of_mine")));
  EXPECT_THAT(check("sphere { 0, 1 pigment { Gray50 } }").err, HasSubstr("`Gray50` is declared in `colors.inc`"));
}

TEST_F(SceneErrors, AMisspeltWordIsPlacedAndAnswered) {
  const ProcessResult result = check("#declare Radius = 1;\nsphere { 0, Raduis }\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("scene.isl:2:13"));
  EXPECT_THAT(result.err, HasSubstr("Radius"));
}

TEST_F(SceneErrors, AnUnknownBlockIsAnError) { EXPECT_EQ(check("sfere { 0, 1 }\n").exit_code, 1); }

TEST_F(SceneErrors, AWrongTypeIsAnError) {
  const ProcessResult result = check("sphere { \"middle\", 1 }\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("scene.isl:1:10"));
}

TEST_F(SceneErrors, ARunawayRecursionMeetsItsLimit) {
  const ProcessResult result = check("#macro Again(N) Again(N + 1) #end\nAgain(0)\n", {"--max-depth", "200"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("--max-depth"));
}

TEST_F(SceneErrors, ARunawayRecursionMeetsTheDefaultLimitToo) {
  const ProcessResult result = check("#macro Again(N) (1 + Again(N + 1)) #end\n#declare A = Again(0);\n");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("--max-depth"));
  EXPECT_LT(result.err.size(), 10000u) << "the chain is abbreviated";
}

TEST_F(SceneErrors, AnEndlessLoopMeetsItsLimit) {
  const ProcessResult result = check("#while (1)\n#end\n", {"--max-turns", "10000"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("--max-turns"));
}

TEST_F(SceneErrors, TooManyPrimitivesMeetTheirLimit) {
  const ProcessResult result = check("#for (I, 1, 1000) sphere { I, 1 } #end\n", {"--max-primitives", "100"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("--max-primitives"));
}

TEST_F(SceneErrors, AFileThatIncludesItselfMeetsItsLimit) {
  const ProcessResult result = check("#include \"scene.isl\"\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("include"));
}

TEST_F(SceneErrors, AMissingIncludeIsPlaced) {
  const ProcessResult result = check("\n  #include \"nowhere.inc\"\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("scene.isl:2:"));
  EXPECT_THAT(result.err, HasSubstr("nowhere.inc"));
}

TEST_F(SceneErrors, AnIncludeMayNotLeaveItsFolders) {
  write("secret.inc", "#declare Secret = 1;\n");
  write("scenes/scene.isl", "#include \"../secret.inc\"\n");
  EXPECT_EQ(run({"check", "scenes/scene.isl"}).exit_code, 1);
  EXPECT_EQ(run({"check", "scenes/scene.isl", "-I", "."}).exit_code, 0) << "unless the user names the folder";
  write("scenes/scene.isl", "#include \"/etc/hostname\"\n");
  EXPECT_EQ(run({"check", "scenes/scene.isl"}).exit_code, 1);
}

TEST_F(SceneErrors, SeveralAreToldInOneRun) {
  const ProcessResult result = check("sphere { 0, A1 }\nsphere { 0, B2 }\nsphere { 0, C3 }\n");
  EXPECT_EQ(result.exit_code, 1);
  for (const char* place : {"scene.isl:1:", "scene.isl:2:", "scene.isl:3:"}) EXPECT_THAT(result.err, HasSubstr(place));
}

TEST_F(SceneErrors, ASettingThatNamesNoSolverIsAnError) {
  const ProcessResult result = check("global_settings { solver \"newton\" }\nsphere { 0, 1 }\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("newton"));
}

TEST_F(SceneErrors, WhatIslDoesNotHaveIsNamedAndLenientSkipsIt) {
  const std::string scene = "sphere { 0, 1 }\nlathe { 2, 0, 1 }\n";
  const ProcessResult strict = check(scene);
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.err, HasSubstr("`lathe` is not supported"));
  const ProcessResult lenient = check(scene, {"--lenient"});
  EXPECT_EQ(lenient.exit_code, 0) << lenient.err;
  EXPECT_THAT(lenient.err, HasSubstr("warning"));
}

}  // namespace
}  // namespace isl::test
