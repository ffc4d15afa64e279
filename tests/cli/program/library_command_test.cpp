// `isl library`: what it prints about files, macros and declarations, and its errors.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class LibraryCommand : public ProgramTest {};

TEST_F(LibraryCommand, ListsFilesWithTheirNames) {
  const ProcessResult result = run({"library"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, testing::ContainsRegex("\ncurves.isl\n  Limbs along smooth curves"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\n  macro +Curve_place Curve_hermite_at "));
  EXPECT_THAT(result.out, testing::ContainsRegex("\n  texture +[^\n]*RedCoral"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\ntransforms.inc +Transforms that"));
}

TEST_F(LibraryCommand, ExplainsAFileByEitherOfItsNames) {
  const ProcessResult result = run({"library", "curves.isl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(run({"library", "curves"}).out, result.out);
  EXPECT_THAT(result.out, testing::StartsWith("curves.isl\n\n  Limbs along smooth curves"));
  EXPECT_THAT(result.out, HasSubstr("\nCurve_place(Point)\n  The place of a point"));
  EXPECT_THAT(run({"library", "stones"}).out, testing::StartsWith("stones.isl\n")) << "ours come first";
  EXPECT_THAT(run({"library", "stones.inc"}).out, testing::StartsWith("stones.inc\n"));
}

TEST_F(LibraryCommand, ExplainsAMacroWithAnExampleThatTheProgramReads) {
  const ProcessResult result = run({"library", "Curve_place"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::StartsWith("Curve_place(Point)\n  macro of curves.isl\n"));
  EXPECT_THAT(result.out, HasSubstr("\n  Point: a vector"));
  EXPECT_THAT(result.out, HasSubstr("\n#include \"curves.isl\"\n"));
  const std::string heading = "\nExample:\n";
  const std::size_t example = result.out.find(heading);
  ASSERT_NE(example, std::string::npos) << result.out;
  write("a.isl", std::string(kSmallScene) + "#include \"curves.isl\"\n" + result.out.substr(example + heading.size()));
  EXPECT_EQ(run({"check", "a.isl"}).exit_code, 0);
}

TEST_F(LibraryCommand, ExplainsADeclaration) {
  const ProcessResult result = run({"library", "RedCoral"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::StartsWith("RedCoral\n  texture of skins.isl\n"));
  EXPECT_THAT(result.out, HasSubstr("\n#include \"skins.isl\"\n"));
  EXPECT_THAT(result.out, Not(HasSubstr("Example")));
}

TEST_F(LibraryCommand, AnswersInJson) {
  const json all = json::parse(run({"library", "--format", "json"}).out).at("libraries");
  EXPECT_GT(all.size(), 20u);
  const json document = json::parse(run({"library", "Curve_place", "--format", "json"}).out);
  ASSERT_EQ(document.at("libraries").size(), 1u);
  const json& library = document["libraries"][0];
  EXPECT_EQ(library.at("file"), "curves.isl");
  EXPECT_EQ(library.at("include"), "#include \"curves.isl\"");
  ASSERT_EQ(library.at("entries").size(), 1u);
  EXPECT_EQ(library["entries"][0].at("parameters"), json({"Point"}));
}

TEST_F(LibraryCommand, NamesWhatAnUnknownNameMayMean) {
  const ProcessResult result = run({"library", "curve_place"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err,
              HasSubstr("isl: error: the standard library has no file, macro or declaration `curve_place`"));
  EXPECT_THAT(result.err, HasSubstr("did you mean `Curve_place`?"));
  EXPECT_THAT(run({"library", "curvs.isl"}).err, HasSubstr("did you mean `curves.isl`?"));
  EXPECT_THAT(run({"library", "Fbxqz\033[2J"}).err,
              testing::AllOf(HasSubstr("Fbxqz\\x1b[2J"), HasSubstr("`isl library` lists")));
}

}  // namespace
}  // namespace isl::test
