// Values that a loop nests in one another, thousands deep, without a text that is nested at all. Objects may be nested
// to any depth; for all other values there is one limit, told with the place. Each attack runs under every command that
// walks over the scene: none may overflow a stack.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

using testing::HasSubstr;

constexpr std::string_view kTooDeep = "this value holds others more than 64 deep within one another";
constexpr std::string_view kView =
    "camera { location <0, 0, -5> look_at 0 } light_source { <5, 5, -5>, 1 } "
    "#macro Around(Inner) #local P = function { pigment { Inner } } pigment { function { P(x, y, z).gray } } #end";

/// A name's first value, what replaces it again and again, and what uses it in the end.
struct Nest {
  std::string_view first, again, use;
};

std::string text_of(const Nest& nest, int depth) {
  return fmt::format("{}\n#declare V = {}\n#for (I, 1, {})\n#declare V = {}\n#end\n{}\n", kView, nest.first, depth,
                     nest.again, nest.use);
}

class Nesting : public AttackTest {
 protected:
  /// Runs each command on the scene; expects the exit code of all of them, and nothing that looks like a crash.
  void expect_of_all(const std::string& text, int exit_code, std::string_view said) {
    write("scene.isl", text);
    const std::vector<std::vector<std::string>> commands = {
        {"check", "scene.isl"},
        {"plan", "scene.isl"},
        {"dump", "--stage", "database", "scene.isl"},
        {"render", "scene.isl", "-s", "8x6", "--samples", "1", "-o", "nest.ppm"}};
    for (const std::vector<std::string>& command : commands) {
      ProcessOptions process;
      process.limit = kTimeBound;
      const ProcessResult result = run(command, process);
      EXPECT_EQ(result.exit_code, exit_code) << command[0] << '\n' << text << '\n' << result.err;
      EXPECT_THAT(result.err, HasSubstr(said)) << command[0] << '\n' << text;
    }
  }
};

TEST_F(Nesting, ObjectsWorkAtAnyDepth) {
  constexpr Nest kNests[] = {
      {"sphere { 0, 1 }", "union { object { V } sphere { <I, 0, 0>, 1 } }", "object { V }"},
      {"sphere { 0, 1 }", "union { sphere { <I, 0, 0>, 1 } object { V rotate 1 translate 1e-3 } }", "object { V }"},
      {"sphere { 0, 1 }", "merge { object { V } sphere { <I, 0, 0>, 1 } }", "object { V }"},
      {"sphere { 0, 1e3 }", "difference { object { V } sphere { <I, 0, 0>, 0.4 } }", "object { V }"},
      {"sphere { 0, 1e3 }", "difference { sphere { 0, I } object { V translate 1e-3 } }", "object { V }"},
      {"sphere { 0, 1 }", "intersection { object { V } sphere { <1e-5 * I, 0, 0>, 1 } }", "object { V }"},
      {"sphere { 0, 1 }", "intersection { union { object { V } sphere { 2*x, 0.1 } } sphere { 0, 3 } }",
       "object { V }"},
      {"sphere { 0, 1 }", "object { sphere { 0, 1 } clipped_by { object { V } } }", "object { V }"},
      {"sphere { 0, 1 }", "object { plane { y, 0 } bounded_by { object { V } } }", "object { V }"},
      {"plane { y, -1 }", "union { object { V } sphere { <I, 0, 0>, 1 } }", "object { V }"},
      {"sphere { 0, 1 no_shadow }", "union { object { V no_shadow } }", "object { V }"},
  };
  for (const Nest& nest : kNests) {
    expect_of_all(text_of(nest, 5'000), 0, "");
  }
}

TEST_F(Nesting, ObjectsAreAskedAtAnyDepth) {
  constexpr std::string_view kUses[] = {
      "#debug str(inside(V, 0), 0, 0)", "#debug str(max_extent(V).x, 0, 0)",
      "#declare N = <0, 0, 0>; #debug vstr(3, trace(V, -5*z, z, N), \",\", 0, 0)",
      "sphere { 0, 1 pigment { object { V rgb 0, rgb 1 } } }",
      "sphere { 0, 1 pigment { object { object { V } pigment { rgb 0 }, pigment { rgb 1 } } } }"};
  constexpr std::string_view kAgain[] = {"union { object { V } sphere { <I, 0, 0>, 1 } }",
                                         "difference { object { V } sphere { <I, 0, 0>, 0.4 } }",
                                         "object { sphere { 0, 1 } clipped_by { object { V } } }"};
  for (const std::string_view use : kUses) {
    for (const std::string_view again : kAgain) {
      expect_of_all(text_of({"sphere { 0, 1 }", again, use}, 5'000), 0, "");
    }
  }
}

TEST_F(Nesting, FiftyThousandUnionsAndDifferencesWork) {
  expect_of_all(text_of({"sphere { 0, 1 }", "union { object { V } sphere { <I, 0, 0>, 1 } }", "object { V }"}, 50'000),
                0, "");
  expect_of_all(
      text_of({"sphere { 0, 1 }", "difference { object { V } sphere { <I, 0, 0>, 0.4 } }", "object { V }"}, 50'000), 0,
      "");
}

TEST_F(Nesting, GroupsThatHoldAGroupTwiceAreAskedOnceForShadows) {
  write("scene.isl", text_of({"sphere { 0, 1 no_shadow }", "union { object { V } object { V } }", "object { V }"}, 60));
  ProcessOptions process;
  process.limit = kTimeBound;
  EXPECT_EQ(run({"plan", "scene.isl"}, process).exit_code, 0);
}

/// Each grows by one level with each turn.
constexpr Nest kValues[] = {
    {"pigment { rgb 1 }", "pigment { gradient x pigment_map { [0 V] [1 rgb 0] } }", "sphere { 0, 1 pigment { V } }"},
    {"pigment { rgb 1 }", "pigment { checker pigment { rgb 0 }, pigment { V } }", "sphere { 0, 1 pigment { V } }"},
    {"pigment { rgb 1 }", "pigment { average pigment_map { [1 V] [1 rgb 0] } }", "sphere { 0, 1 pigment { V } }"},
    {"pigment { gradient x }", "pigment { pigment_pattern { V } color_map { [0 rgb 0] [1 rgb 1] } }",
     "sphere { 0, 1 pigment { V } }"},
    {"pigment { rgb 1 }", "pigment { gradient x pigment_map { [0 V] [1 rgb 0] } rotate 1 }",
     "fog { distance 9 } sky_sphere { pigment { V } } sphere { 0, 1 }"},
    {"texture { pigment { rgb 1 } }", "texture { gradient x texture_map { [0 V] [1 pigment { rgb 0 }] } }",
     "sphere { 0, 1 texture { V } }"},
    {"texture { pigment { rgb 1 } }", "texture { checker texture { V }, texture { pigment { rgb 0 } } }",
     "sphere { 0, 1 texture { V } }"},
    {"normal { bumps }", "normal { gradient x normal_map { [0 V] [1 dents 1] } }",
     "#declare Never = sphere { 0, 1 normal { V } }"},
    {"normal { bumps }", "normal { checker normal { V }, normal { dents 1 } }",
     "#declare Never = sphere { 0, 1 normal { V } }"},
    {"pigment { gradient x }", "Around(V)",
     "sphere { 0, 1 pigment { V } } #declare F = function { pigment { V } } #debug str(F(0, 0, 0).x, 0, 0)"},
    {"array[1] { 1 }", "array[1] { V }", "#declare W = V"},
};

TEST_F(Nesting, ValuesWorkUpToTheLimit) {
  for (const Nest& nest : kValues) expect_of_all(text_of(nest, 62), 0, "");
}

TEST_F(Nesting, ValuesBeyondTheLimitAreAnErrorAtTheirPlace) {
  for (const Nest& nest : kValues) {
    expect_of_all(text_of(nest, 5'000), 1, kTooDeep);
    expect_of_all(text_of(nest, 5'000), 1, "scene.isl:4:");
  }
}

TEST_F(Nesting, FunctionsThatCallFunctionsHaveTheSameLimit) {
  // A function is declared only once, so that each has a name of its own.
  const auto chain = [](int depth) {
    std::string text = "#declare F0 = function (x) { x }\n";
    for (int i = 1; i <= depth; ++i) text += fmt::format("#declare F{} = function (x) {{ F{}(x) + 1 }}\n", i, i - 1);
    return text + fmt::format("#debug str(F{}(0), 0, 0)\n", depth);
  };
  expect_of_all(chain(63), 0, "63");
  expect_of_all(chain(5'000), 1, kTooDeep);
}

TEST_F(Nesting, FunctionsWithTheLargestFramesFitTheStack) {
  // A chain of 62 functions needs more than the usual frame, and each pattern evaluates one.
  std::string text = "#declare F0 = function (x, y, z) { x }\n";
  for (int i = 1; i <= 62; ++i)
    text += fmt::format("#declare F{} = function (x, y, z) {{ F{}(x, y, z) + 1e-3 }}\n", i, i - 1);
  text +=
      "#macro AroundFunctions(Inner) #local P = function { pigment { Inner } }\n"
      "pigment { function { F62(x, y, z) + P(x, y, z).gray } } #end\n";
  expect_of_all(text + text_of({"pigment { rgb 1 }", "AroundFunctions(V)", "sphere { 0, 1 pigment { V } }"}, 60), 0,
                "");
}

TEST_F(Nesting, LayersOfTexturesAreNoDepth) {
  expect_of_all(
      text_of({"texture { pigment { rgb 1 } }",
               "texture { V } texture { pigment { gradient x color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.9>] } } }",
               "sphere { 0, 1 texture { V } }"},
              2'000),
      0, "");
}

TEST_F(Nesting, ArraysThatGrowInTheirElementsAreDestroyedAndCopied) {
  // Each call goes 60 levels down by reference, and hangs an array 60 deep below: nothing that is assigned is too deep.
  const std::string down = repeated("[0]", 60);
  expect_of_all(fmt::format(R"({}
#declare V = array[1] {{ 1 }}
#for (I, 1, 60) #declare V = array[1] {{ V }} #end
#declare Root = V
#macro Grow(Element, N) #if (N > 0) Grow(Element{}, N - 1) #else #declare Element = V #end #end
#for (I, 1, 900) Grow(Root, I - 1) #end
#declare Copy = Root
)",
                            kView, down),
                0, "");
}

}  // namespace
}  // namespace isl::test
