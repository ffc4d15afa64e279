// The files of a scene: messages about missing ones, the search path, and the names in messages; and the view.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Files : public ProgramTest {
 public:
  ~Files() override { unsetenv("ISL_SYSTEM_LIBRARIES"); }
};

TEST_F(Files, ThatAreMissingAreErrorsWhereverTheyAreRead) {
  for (const char* const use :
       {"sphere { 0, 1 pigment { image_map { png \"none.png\" } } }",
        "sphere { 0, 1 normal { bump_map { png \"none.png\" } } }",
        "sphere { 0, 1 pigment { image_pattern { png \"none.png\" } } }",
        "sphere { 0, 1 texture { material_map { png \"none.png\" texture { pigment { rgb 1 } } } } }",
        "sphere { 0, 1 pigment { density_file df3 \"none.png\" } }", "#include \"none.png\"",
        "#fopen F \"none.png\" read"}) {
    write("a.isl", std::string(kSmallScene) + use);
    for (const char* const command : {"check", "render"}) {
      const ProcessResult result = run({command, "a.isl"});
      EXPECT_EQ(result.exit_code, 1) << command << use;
      EXPECT_THAT(result.err, HasSubstr("a.isl:6:")) << command << use;
      EXPECT_THAT(result.err, HasSubstr("error: cannot find `none.png`")) << command << use;
    }
  }
}

TEST_F(Files, OfDensitiesAreWrittenByTheLibraryOfArrays) {
  write("a.isl", std::string(kSmallScene) +
                     "#include \"arrays.inc\"\n#declare Cells = array[2][1] { { 0 }, { 1 } }\n"
                     "ARRAYS_WriteDF3(Cells, \"cells.df3\", 8)\n");
  EXPECT_EQ(run({"check", "a.isl"}).exit_code, 1) << "it may not write";
  const ProcessResult result = run({"check", "a.isl", "--allow-write", "."});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  // Three sizes of two bytes each, then a byte for each cell.
  EXPECT_EQ(read("cells.df3"), (std::string{0, 2, 0, 1, 0, 1, 0, '\xff'}));
}

TEST_F(Files, ThatAreMisspeltAreNamedAndFoldersThatAreMissingAreToldOf) {
  write("a.isl", "#include \"colurs.inc\"\n");
  EXPECT_THAT(run({"check", "a.isl"}).err, HasSubstr("did you mean `colors.inc`?"));
  write("b.isl", kSmallScene);
  const ProcessResult searched = run({"check", "b.isl", "-I", "nowhere"});
  EXPECT_EQ(searched.exit_code, 0);
  EXPECT_THAT(searched.err, HasSubstr("warning: the search path names `nowhere`, which is not a folder"));
  const ProcessResult rendered = run({"render", "b.isl", "-o", "none/b.png", "-s", "16x12"});
  EXPECT_EQ(rendered.exit_code, 3);
  EXPECT_THAT(rendered.err, HasSubstr("cannot write none/b.png: there is no folder none"));
}

TEST_F(Files, ThatAreNoImagesAreErrorsAtTheirPlaceWhenTheyAreDecoded) {
  write("c.png", "no picture");
  write("b.ppm", "P6 2 1 255\n" + std::string("\xff\x80\x01", 3));
  const auto render = [this](std::string_view use) {
    write("a.isl", std::string(kSmallScene) + std::string(use));
    EXPECT_EQ(run({"check", "a.isl"}).exit_code, 0) << "it decodes nothing";
    const ProcessResult result = run({"render", "a.isl", "-s", "16x12"});
    EXPECT_EQ(result.exit_code, 1) << use;
    EXPECT_FALSE(exists("a.png"));
    return result.err;
  };
  EXPECT_THAT(render("plane { y, -1 pigment { image_map { png \"c.png\" } } }"),
              HasSubstr("a.isl:6:41: error: the image `c.png`: it cannot be read as png: it is not a PNG file"));
  EXPECT_THAT(render("plane { y, -1 pigment { image_map { jpeg \"c.png\" } } }"),
              HasSubstr("error: the image `c.png`: it cannot be read as jpeg: "));
  EXPECT_THAT(render("plane { y, -1 pigment { image_map { \"b.ppm\" } } }"),
              HasSubstr("error: the image `b.ppm`: it cannot be read as ppm: "));
}

TEST_F(Files, OfImagesAreDecodedOnlyForWhatIsDrawn) {
  write("c.png", "no picture");
  write("a.isl", std::string(kSmallScene) + "#declare Unused = pigment { image_map { png \"c.png\" } }\n");
  EXPECT_EQ(run({"render", "a.isl", "-s", "16x12"}).exit_code, 0);
  write("b.isl", std::string(kSmallScene) + "plane { y, -1 pigment { image_map { png \"c.png\" } } }\n");
  EXPECT_EQ(run({"render", "b.isl", "-s", "16x12", "--without", "images"}).exit_code, 0);
  EXPECT_THAT(run({"plan", "b.isl"}).out, HasSubstr("an image at b.isl:6:41"));
}

TEST_F(Files, OfImagesAreFoundWithoutTheirExtension) {
  write("a.ppm", "P6 1 1 255\n" + std::string("\xff\x80\x01", 3));
  write("a.isl", std::string(kSmallScene) + "plane { y, -1 pigment { image_map { ppm \"a\" } } }\n");
  EXPECT_EQ(run({"render", "a.isl", "-s", "16x12"}).exit_code, 0);
}

TEST_F(Files, OfImagesAreReadByFunctionsThatTheSceneCalls) {
  write("a.ppm", "P6 2 1 255\n" + std::string("\xff\x80\x01\x00\x00\x33", 6));
  write("a.isl",
        "#version 3.7; global_settings { assumed_gamma 1 }\n"
        "#declare F = function { pigment { image_map { ppm \"a.ppm\" } } }\n"
        "#debug concat(str(F(.7, .5, 0).blue, 0, 3), \" \", str(F(.2, .5, 0).red, 0, 3))\nsphere { 0, 1 }\n");
  EXPECT_THAT(run({"check", "a.isl"}).err, HasSubstr("0.200 1.000"));
  write("a.ppm", "no picture");
  EXPECT_THAT(run({"check", "a.isl"}).err, HasSubstr("a.isl:3:"));
}

TEST_F(Files, AreNamedWithTheirHashesByCheck) {
  write("scene/a.isl", std::string(kSmallScene) + "#include \"inc/b.inc\"\n#include \"inc/b.inc\"\n");
  write("scene/inc/b.inc", "#declare B = pigment { image_map { png \"c.png\" } }");
  write("scene/inc/c.png", "one picture");
  const std::string out = run({"check", "scene/a.isl"}).out;
  EXPECT_THAT(out, testing::ContainsRegex("files:\n  [0-9a-f]{16} a.isl .scene/a.isl.\n"
                                          "  [0-9a-f]{16} inc/b.inc .scene/inc/b.inc.\n"
                                          "  [0-9a-f]{16} inc/c.png .scene/inc/c.png.\n$"));
  const json files = json::parse(run({"check", "scene/a.isl", "--format", "json"}).out)["files"];
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[2]["name"], "inc/c.png");
  write("scene/inc/c.png", "another picture");
  const json changed = json::parse(run({"check", "scene/a.isl", "--format", "json"}).out)["files"];
  EXPECT_EQ(changed[1], files[1]);
  EXPECT_NE(changed[2]["hash"], files[2]["hash"]);
}

TEST_F(Files, AreNamedInThePictureWithoutTheMachinesFolders) {
  for (const char* const place : {"here", "there/and/there"}) {
    write(std::string(place) + "/a.isl", std::string(kSmallScene) + "#include \"lib.inc\"\n");
    write(std::string(place) + "/library/lib.inc", "#declare Lib = 1;");
    const std::string library = (folder() / place / "library").string();
    const std::string picture = place == std::string("here") ? "x.png" : "y.png";
    EXPECT_EQ(run({"render", std::string(place) + "/a.isl", "-I", library, "-s", "8x6", "-o", picture}).exit_code, 0);
  }
  EXPECT_EQ(read("x.png"), read("y.png"));
  EXPECT_THAT(read("x.png"), HasSubstr("isl:Files"));
  EXPECT_THAT(read("x.png"), HasSubstr(" a.isl\n"));
  EXPECT_THAT(read("x.png"), HasSubstr(" lib.inc"));
  EXPECT_THAT(read("x.png"), Not(HasSubstr(folder().string())));
}

TEST_F(Files, OfTheSystemsLibrariesAreFoundLast) {
  write("system/fabrics.inc", "#include \"colors.inc\" #declare T = texture { pigment { Own } }");
  write("system/colors.inc", "#declare Own = rgb <1, 0, 0>;");
  write("system/own.inc", "#declare Own = rgb <0, 0, 1>;");
  write("library/own.inc", "#declare Own = rgb <0, 1, 0>;");
  write("a.isl", std::string(kSmallScene) +
                     "#include \"fabrics.inc\"\n#include \"colors.inc\"\n"
                     "sphere { x, 1 texture { T } }\nsphere { -x, 1 pigment { White } }\n#include \"own.inc\" #debug "
                     "str(Own.green, 0, 0)\n");
  EXPECT_THAT(run({"check", "a.isl"}).err, HasSubstr("cannot find `fabrics.inc`")) << "no test finds them by accident";
  setenv("ISL_SYSTEM_LIBRARIES", (folder() / "system").c_str(), 1);
  const ProcessResult mixed = run({"check", "a.isl", "-I", "library"});
  EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
  EXPECT_EQ(mixed.err, "1") << "-I comes first";
  EXPECT_THAT(mixed.out, testing::ContainsRegex("[0-9a-f]{16} fabrics.inc .*/system/fabrics.inc"));
  EXPECT_THAT(mixed.out, testing::ContainsRegex("[0-9a-f]{16} colors.inc .*/system/colors.inc"))
      << "an include file of theirs finds its own neighbours";
  EXPECT_THAT(mixed.out, testing::ContainsRegex("[0-9a-f]{16} colors.inc .*/(stdlib|share/isl)/colors.inc"))
      << "the scene finds the standard library before";
  for (const char* const command : {"check", "render", "dump", "accuracy"}) {
    std::vector<std::string> arguments{command, "a.isl", "--no-system-libraries"};
    if (arguments[0] == "dump") arguments.insert(arguments.end(), {"--stage", "database"});
    const ProcessResult without = run(arguments);
    EXPECT_EQ(without.exit_code, 1) << command;
    EXPECT_THAT(without.err, HasSubstr("cannot find `fabrics.inc`")) << command;
  }
}

TEST_F(Files, OfTheSystemsLibrariesLeadNowhereElse) {
  write("secret.inc", "#declare Key = \"opensesame\"; #debug Key");
  std::filesystem::create_directory(folder() / "system");
  std::filesystem::create_symlink("../secret.inc", folder() / "system/link.inc");
  write("scene/a.isl", std::string(kSmallScene) + "#include \"link.inc\"\n");
  setenv("ISL_SYSTEM_LIBRARIES", (folder() / "system").c_str(), 1);
  const ProcessResult result = run({"check", "scene/a.isl"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("is outside the folders"));
  EXPECT_THAT(result.err, Not(HasSubstr("opensesame")));
}

TEST_F(Files, OfTheSystemsLibrariesComeBeforeOursWhereThatIsAskedFor) {
  write("system/colors.inc", "#declare Whose = 1;");
  write("system/own.inc", "#declare Own = 1;");
  write("library/own.inc", "#declare Own = 2;");
  write("a.isl", std::string(kSmallScene) +
                     "#include \"colors.inc\"\n#include \"own.inc\"\n"
                     "#debug concat(str(defined(Whose), 0, 0), str(defined(White), 0, 0), str(Own, 0, 0))\n");
  setenv("ISL_SYSTEM_LIBRARIES", (folder() / "system").c_str(), 1);
  EXPECT_EQ(run({"check", "a.isl", "-I", "library"}).err, "012");
  for (const char* const command : {"check", "plan", "render"}) {
    const ProcessResult first = run({command, "a.isl", "-I", "library", "--system-libraries-first", "-s", "8x6"});
    EXPECT_THAT(first.err, testing::StartsWith("102")) << command << ": -I comes first even then";
  }
  write("system/arrays.inc", "#include \"math.inc\"");
  write("b.isl", std::string(kSmallScene) + "#include \"arrays.inc\"\n");
  EXPECT_THAT(run({"check", "b.isl", "--system-libraries-first"}).out,
              testing::ContainsRegex("[0-9a-f]{16} math.inc .*/(stdlib|share/isl)/math.inc"))
      << "a file that theirs lack is found among ours";
}

TEST_F(Files, ThatTheCommandLineMissesAreNamedWithTheFileMeant) {
  write("sub/Ball.pov", kSmallScene);
  EXPECT_THAT(run({"check", "sub/ball.pov"}).err, HasSubstr("file names distinguish capitals"));
  EXPECT_THAT(run({"check", "sub\\Ball.pov"}).err, HasSubstr("there is `sub/Ball.pov` in .: write that name"));
  write("sub/a.ini", "Input_File_Name=BALL.POV\n");
  EXPECT_THAT(run({"check", "sub/a.ini"}).err, HasSubstr("there is `Ball.pov` in sub"));
}

TEST_F(Files, AreFoundWithoutTheirExtension) {
  write("a.isl", std::string(kSmallScene) + "#include \"near\" #debug str(Near, 0, 0)\n");
  write("near.inc", "#declare Near = 1;");
  EXPECT_EQ(run({"check", "a.isl"}).err, "1");
}

TEST_F(Files, InUtf16AreNamedWithTheRemedy) {
  using namespace std::string_view_literals;
  write("a.isl", "#include \"wide.inc\"");
  write("wide.inc", "\xFF\xFE#\0d\0e\0"sv);
  const ProcessResult result = run({"check", "a.isl"});
  EXPECT_THAT(result.err, HasSubstr("a.isl:1:10: error: cannot read `wide.inc`: it is UTF-16 text"));
  EXPECT_THAT(result.err, HasSubstr("save it as UTF-8"));
  write("b.isl", "\xFF\xFE#\0d\0e\0"sv);
  EXPECT_THAT(run({"check", "b.isl"}).err, HasSubstr("cannot read `b.isl`: it is UTF-16 text"));
}

class View : public ProgramTest {};

TEST_F(View, OfNothingIsToldByCheckAndRender) {
  const std::string objects = "light_source { 9, 1 }\nblob { threshold 0.5 sphere { <30, 5, 2>, 3, 1 } }\n";
  const std::string blind = "camera { location <0, 0, -5> look_at <0, 0, -9> }\n";
  for (const std::string& camera : {blind, std::string()}) {
    write("a.isl", camera + objects);
    for (const char* const command : {"check", "render"}) {
      const ProcessResult result = run({command, "a.isl", "-s", "8x6"});
      EXPECT_EQ(result.exit_code, 0) << command;
      EXPECT_THAT(result.err, HasSubstr("sees nothing of the scene")) << command << camera;
      EXPECT_THAT(result.err, HasSubstr("this one sees it: camera { location")) << command << camera;
    }
  }
}

}  // namespace
}  // namespace isl::test
