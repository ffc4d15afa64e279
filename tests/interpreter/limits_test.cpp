// The limits of a runaway script. Each message must name its option.
#include "tests/interpreter/evaluated_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace isl::test {
namespace {

using interpreter::EvaluateOptions;
using testing::HasSubstr;

/// The hint of the only error.
std::string hint(const EvaluatedText& scene) {
  EXPECT_EQ(scene.sink().error_count(), 1u) << scene.messages();
  return scene.sink().diagnostics().empty() ? "" : scene.sink().diagnostics().back().hint;
}

TEST(Limits, EndlessLoopEndsAfterTheTurnsAllowed) {
  EvaluateOptions options;
  options.limits.max_turns = 1000;
  EXPECT_THAT(hint(EvaluatedText("#while (1) #end", options)), HasSubstr("--max-turns"));
  EXPECT_THAT(hint(EvaluatedText("#for (I, 0, 1e9) #end", options)), HasSubstr("--max-turns"));
}

TEST(Limits, LoopsAndCallsWithinFunctionsAreBoundedToo) {
  EvaluateOptions options;
  options.limits.max_turns = 1000;
  constexpr std::string_view kSum = "#declare F = function(a) {{ sum(i, 1, a, i) }} #declare A = F({});";
  EXPECT_EQ(EvaluatedText(fmt::format(kSum, 900), options).messages(), "");
  EXPECT_THAT(hint(EvaluatedText(fmt::format(kSum, 1e9), options)), HasSubstr("--max-turns"));
  EXPECT_THAT(hint(EvaluatedText(fmt::format(kSum, "1/0"), options)), HasSubstr("--max-turns"));
  std::string doubling = "#declare F0 = function(a) { a }\n";
  for (int i = 1; i < 40; ++i) doubling += fmt::format("#declare F{0} = function(a) {{ F{1}(a)+F{1}(a) }}\n", i, i - 1);
  EXPECT_THAT(hint(EvaluatedText(doubling + "#declare A = F39(1);", options)), HasSubstr("--max-turns"));
}

TEST(Limits, FunctionsCallOneAnotherOnlySoDeep) {
  std::string chain = "#declare F0 = function(a) { a }\n";
  for (int i = 1; i < 65; ++i) chain += fmt::format("#declare F{} = function(a) {{ F{}(a) }}\n", i, i - 1);
  EXPECT_THAT(EvaluatedText(chain).messages(), HasSubstr("more than 64 deep within one another"));
}

TEST(Limits, TurnsOfAllLoopsCountTogether) {
  EvaluateOptions options;
  options.limits.max_turns = 1000;
  constexpr std::string_view kScene = "#for (I, 1, {}) #for (J, 1, 9) #end #end";
  EXPECT_EQ(EvaluatedText(fmt::format(kScene, 100), options).messages(), "");
  EXPECT_THAT(hint(EvaluatedText(fmt::format(kScene, 101), options)), HasSubstr("--max-turns"));
}

TEST(Limits, PrimitivesAreCountedWhateverTheyAre) {
  EvaluateOptions options;
  options.limits.max_primitives = 10;
  EXPECT_EQ(EvaluatedText("#for (I, 1, 10) sphere { 0, 1 } #end", options).messages(), "");
  EXPECT_THAT(hint(EvaluatedText("#for (I, 1, 11) sphere { 0, 1 } #end", options)), HasSubstr("--max-primitives"));
  EXPECT_THAT(hint(EvaluatedText("blob { #for (I, 1, 11) sphere { 0, 1, 1 } #end }", options)),
              HasSubstr("--max-primitives"));
  EXPECT_THAT(hint(EvaluatedText("#for (I, 1, 11) light_source { 0, 1 } #end", options)),
              HasSubstr("--max-primitives"));
  EXPECT_THAT(hint(EvaluatedText("#for (I, 1, 11) union { } #end", options)), HasSubstr("--max-primitives"));
}

TEST(Limits, MemoryIsCountedForComponentsStringsAndArrays) {
  EvaluateOptions options;
  options.limits.max_memory_bytes = 1'000'000;
  EXPECT_THAT(hint(EvaluatedText("blob { #while (1) sphere { 0, 1, 1 } #end }", options)), HasSubstr("--max-memory"));
  EXPECT_THAT(hint(EvaluatedText("#declare S = \"x\"; #while (1) #declare S = concat(S, S); #end", options)),
              HasSubstr("--max-memory"));
  EXPECT_THAT(hint(EvaluatedText("#declare A = array[1e6]", options)), HasSubstr("--max-memory"));
  EXPECT_THAT(hint(EvaluatedText("#declare A = array[1e6][1e6][1e6]", options)), HasSubstr("--max-memory"));
  EXPECT_THAT(
      hint(EvaluatedText(
          "#declare A = array[999] #declare I = 0; #while (1) #declare A[I] = concat(str(I, 900, 0)); "
          "#declare I = mod(I + 1, 998); #declare B = array[999] #declare A[998] = B; #declare A[998] = A; #end",
          options)),
      HasSubstr("--max-memory"));
}

TEST(Limits, MemoryOfWhatWasGivenUpIsFreeAgain) {
  EvaluateOptions options;
  options.limits.max_memory_bytes = 1'000'000;
  EXPECT_EQ(EvaluatedText("#for (I, 1, 1000) #declare S = str(I, 1000, 0); #declare A = array[1000] #end", options)
                .messages(),
            "");
}

TEST(Limits, RecordsOfTexturesCount) {
  EvaluateOptions options;
  options.limits.max_memory_bytes = 1'000'000;
  for (const std::string_view body :
       {"#declare P = pigment { checker }", "#declare N = normal { bumps }", "#declare M = color_map { [0 rgb 1] }",
        "#declare M = pigment_map { [0 checker] }", "#declare S = slope_map { [0 <0, 1>] }",
        "#declare T = texture { bozo texture_map { [0 pigment { rgb 1 }] } }",
        "#declare P = pigment { image_map { function 4, 4 { pigment { checker } } } }"}) {
    EXPECT_THAT(hint(EvaluatedText(fmt::format("#while (1) {} #end", body), options)), HasSubstr("--max-memory"))
        << body;
  }
}

TEST(Limits, AnInterruptEndsALoop) {
  StopFlag stop;
  stop.set(StopReason::interrupt);
  EvaluateOptions options;
  options.run.stop = &stop;
  EXPECT_EQ(EvaluatedText("#while (1) #end", options).messages(), "error: interrupted\n");
  EXPECT_EQ(EvaluatedText("#macro F() #end #macro G() F() F() #end #while (1) G() #end", options).messages(),
            "error: interrupted\n");
}

TEST(Limits, CopiesOfADeclaredObjectCount) {
  EvaluateOptions options;
  options.limits.max_primitives = 10;
  constexpr std::string_view kSphere = "#declare S = sphere { 0, 1 }";
  for (const std::string_view body : {"S", "object { S }", "union { S }", "sphere { S }"}) {
    EXPECT_THAT(hint(EvaluatedText(fmt::format("{} #while (1) {} #end", kSphere, body), options)),
                HasSubstr("--max-primitives"));
  }
}

TEST(Limits, AWarningOfALoopIsSaidOnce) {
  EXPECT_EQ(EvaluatedText("#for (I, 1, 1000) #declare A = 1 / 0; #end").messages(), "warning: division by zero\n");
}

TEST(Limits, WarningsAreNotWithoutEnd) {
  const EvaluatedText scene("#for (I, 1, 1000) #warning str(I, 0, 0) #end");
  EXPECT_EQ(scene.sink().diagnostics().size(), 101u);
  EXPECT_EQ(scene.sink().diagnostics().back().message, "100 warnings were shown; further warnings are suppressed");
}

TEST(Limits, ReadingStopsAfterTwentyErrors) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += fmt::format("sphere {{ 0, Missing{} }}\n", i);
  EXPECT_EQ(EvaluatedText(text).sink().error_count(), 20u);
}

}  // namespace
}  // namespace isl::test
