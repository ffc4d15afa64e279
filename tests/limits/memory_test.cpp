// Scenes and command lines that ask for more memory than they may have, in every phase of a run. Each ends with a
// message that names the place and the option, and before it has the memory that it asks for.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

constexpr std::size_t kPeakBytes = std::size_t{650} << 20;

class Memory : public AttackTest {
 protected:
  /// Renders the scene under a limit of 500M.
  [[nodiscard]] ProcessResult render(std::string_view text, std::vector<std::string> options = {}) {
    std::vector<std::string> command{"render", write("scene.isl", text), "-q",  "-t", "2", "-o",
                                     "a.png",  "--max-memory",           "500M"};
    if (options.empty()) options = {"-s", "32x24"};
    command.insert(command.end(), options.begin(), options.end());
    ProcessOptions process;
    process.limit = kTimeBound;
    ProcessResult result = run(command, process);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their own memory is a multiple of the program's
    EXPECT_LT(result.peak_bytes, kPeakBytes) << text << "\n" << result.err;
#endif
    EXPECT_TRUE(result.exit_code == 0 || !exists("a.png"));
    return result;
  }

  /// The scene must be refused at a place of its text.
  void expect_refusal(std::string_view text) {
    const ProcessResult result = render(text);
    EXPECT_EQ(result.exit_code, 1) << text << "\n" << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("scene.isl:"), HasSubstr("error:"), HasSubstr("`--max-memory` raises")))
        << text;
  }

  static std::string doubled(std::string_view operation, std::string_view rest = "") {
    return fmt::format(
        "#declare U = sphere {{ 0, 1 }}\n"
        "#for (I, 1, 60) #declare U = {0} {{ object {{ U }} object {{ U translate x }} {1} }} #end\n"
        "object {{ U }}\n",
        operation, rest);
  }
};

TEST_F(Memory, OfInstancesIsCountedBeforeTheyAreMade) {
  expect_refusal(doubled("union"));
  expect_refusal(doubled("union", "pigment { checker }"));
  expect_refusal(
      "#declare U = blob { threshold 0.5 sphere { 0, 1, 1 } }\n"
      "#for (I, 1, 22) #declare U = union { object { U } object { U translate x } } #end object { U }");
  EXPECT_THAT(render(doubled("union")).err, HasSubstr("scene.isl:3:1: error: the 1.153e+18 objects placed up to here"));
}

TEST_F(Memory, OfGroupsOfNothingIsNone) {
  for (const std::string_view operation : {"union", "merge", "intersection", "difference"}) {
    const std::string nothing = fmt::format(
        "#declare U = union {{ }}\n#for (I, 1, 60) #declare U = {} {{ object {{ U }} object {{ U }} }} #end\n",
        operation);
    for (const std::string_view placed : {"object { U }", "difference { sphere { 0, 1 } object { U } }",
                                          "sphere { 0, 1 clipped_by { object { U inverse } } }"}) {
      const ProcessResult result = render(nothing + std::string(placed), {"-s", "4x3", "-o", "b.png"});
      EXPECT_EQ(result.exit_code, 0) << operation << ": " << placed << "\n" << result.err;
    }
  }
}

TEST_F(Memory, OfTreesIsCountedBeforeTheyAreMade) {
  expect_refusal(doubled("intersection"));
  expect_refusal(doubled("merge"));
  expect_refusal(doubled("difference"));
  expect_refusal(doubled("union", "clipped_by { plane { y, 0.5 } }"));
  expect_refusal(doubled("union", "inverse"));
}

TEST_F(Memory, OfQuestionsAboutObjectsCounts) {
  expect_refusal(doubled("union") + "#declare P = trace(U, <0, 0, -5>, z);");
  expect_refusal(doubled("difference") + "#declare P = trace(U, <0, 0, -5>, z);");
  expect_refusal("#for (I, 1, 1e6) #declare P = trace(sphere { 0, I }, <0, 0, -5>, z); #end sphere { 0, 1 }");
}

TEST_F(Memory, OfPicturesIsToldBeforeTheSceneIsRead) {
  const std::vector<std::vector<std::string>> options = {
      {"-s", "65536x65536"},
      {"-s", "65536x65536", "--samples", "1"},
      {"-s", "2500x2000", "--aov", "cost,error"},
      {"-s", "2500x2000", "--aov", "depth,position,normal,albedo", "-o", "a.exr"},
      {"-s", "65536x65536", "--crop", "100,100,20000,20000"},
  };
  for (const std::vector<std::string>& asked : options) {
    const ProcessResult result = render("#error \"read\"", asked);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("--size " + asked[1]), HasSubstr("`--max-memory` raises")));
  }
  EXPECT_THAT(render("#error \"read\"", {"-s", "65536x65536", "--crop", "0,0,100,100"}).err, HasSubstr("error: read"))
      << "a part of a large picture is small";
}

TEST_F(Memory, OfValuesCounts) {
  expect_refusal("#declare A = array[1] {1} #for (I, 1, 40) #declare B = array[2] {A, A} #declare A = B; #end");
  expect_refusal("#declare A = array[1e7] #for (I, 0, 1e7 - 1) #declare A[I] = array[1] {I} #end");
  expect_refusal("#declare S = \"x\"; #for (I, 1, 60) #declare S = concat(S, S); #end");
  expect_refusal("#declare S = spline { #for (I, 0, 1e9) I, <I, 0, 0> #end }");
  expect_refusal("#macro F(N, A) #local B = array[100000] F(N + 1, B) #end F(0, 0)");
}

TEST_F(Memory, OfWhatASceneHoldsCounts) {
  expect_refusal("#while (1) sphere { 0, 1 } #end");
  expect_refusal("union { #while (1) sphere { 0, 1 } #end }");
  expect_refusal("blob { threshold 0.5 #while (1) sphere { 0, 1, 1 } #end }");
  expect_refusal("#while (1) light_source { 0, 1 } #end");
  expect_refusal("#while (1) triangle { x, y, z } #end");
  expect_refusal("#while (1) #declare P = pigment { bozo turbulence 1 color_map { [0 rgb 0] [1 rgb 1] } } #end");
  expect_refusal("#declare I = 0; #while (1) #declare I = I + 1; sphere { 0, 1 pigment { rgb I } } #end");
  expect_refusal("#while (1) polygon { 4, 0, x, x + y, 0 } #end");
}

TEST_F(Memory, OfGridsCounts) {
  // A body with a sheet of a ten-thousandth of its size among overlapping balls.
  std::string body = "blob { threshold 1\n";
  for (int i = 0; i < 16; ++i) body += fmt::format("sphere {{ <{}, 0, 0>, 3, {} }}\n", i * 0.1, i % 2 == 0 ? 4 : -3);
  const ProcessResult sheet = render(body + "sphere { 0, 1, 2 scale <1, 1e-4, 1> } }", {"-s", "8x6", "-o", "b.png"});
  EXPECT_THAT(sheet.exit_code, AnyOf(0, 1)) << sheet.err;
  const ProcessResult far =
      render("blob { threshold 0.5 sphere { 0, 1e308, 1 } sphere { 0, 1, 1 } sphere { x, 1, 1 } sphere { y, 1, 1 } }",
             {"-s", "8x6", "-o", "b.png"});
  EXPECT_THAT(far.exit_code, AnyOf(0, 1)) << far.err;
}

}  // namespace
}  // namespace isl::test
