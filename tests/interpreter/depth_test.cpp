// Recursion of every kind that the evaluator has, driven to its limit. It must end in a message and never overflow the
// stack. Under AddressSanitizer the same tests measure the stack that interpreter/nesting.h promises.
#include "tests/interpreter/evaluated_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#ifdef __SANITIZE_THREAD__
#define SKIP_UNDER_THREAD_SANITIZER() GTEST_SKIP() << "ThreadSanitizer keeps no stack of more than 65,535 calls"
#else
#define SKIP_UNDER_THREAD_SANITIZER() static_cast<void>(0)
#endif

namespace isl::test {
namespace {

using testing::HasSubstr;

constexpr std::string_view kTooDeep = "open at once";

std::string repeated(std::string_view text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(Depth, RecursionThatEndsBelowTheLimitWorks) {
  const EvaluatedText scene(R"(
    #macro Down(N) #if (N > 0) Down(N - 1) #else sphere { 0, 1 } #end #end
    Down(990))");
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.database().solids.size(), 1u);
}

TEST(Depth, RecursionInsideExpressionsThatEndsBelowTheLimitWorks) {
  const EvaluatedText scene(R"(
    #macro Sum(N) #if (N < 1) 0 #else (N + Sum(N - 1)) #end #end
    #debug str(Sum(990), 0, 0))");
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "490545");
}

TEST(Depth, RecursionThroughDeclarationsIsCountedOnceACall) {
  const EvaluatedText scene(R"(
    #macro Sum(N) #if (N < 1) #local R = 0; #else #local R = N + Sum(N - 1); #end R #end
    #debug str(Sum(990), 0, 0))");
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "490545");
}

TEST(Depth, EndlessRecursionOfMacrosIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro F() F() #end F()").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInsideExpressionsIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro F() (1 + 2*(3 - F())) #end #declare A = F();").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInArgumentsIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro G(A) A #end #macro F() G(G(G(F()))) #end #declare A = F();").messages(),
              HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInConditionsIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro F() #if (F()) 1 #end #end #while (F()) #end").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInVectorsAndFunctionsIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro F() vlength(<F(), max(1, F()), 3>) #end #declare A = F();").messages(),
              HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionOfBlocksIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro U() union { U() } #end U()").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInDeclaredBlocksIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro U() #local V = union { U() } V #end U()").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInModifiersIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro T() transform { T() } #end sphere { 0, 1 T() }").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, EndlessRecursionInArraysIsAnError) {
  EXPECT_THAT(EvaluatedText("#macro A() array[1] { A() } #end #declare B = A();").messages(), HasSubstr(kTooDeep));
}

TEST(Depth, DeeplyNestedBlocksWork) {
  const EvaluatedText scene(repeated("union { ", 900) + "sphere { 0, 1 }" + repeated(" }", 900));
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.database().groups.size(), 900u);
}

TEST(Depth, DeeplyNestedExpressionsWork) {
  const EvaluatedText scene("#debug str(" + repeated("(1 + ", 900) + "0" + repeated(")", 900) + ", 0, 0)");
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "900");
}

TEST(Depth, ExpressionsInEveryCallOfADeepRecursionWorkOrAreAnError) {
  SKIP_UNDER_THREAD_SANITIZER();
  // Each call in progress holds an expression 200 deep, which is more than the stack is made for.
  const EvaluatedText scene("#macro F(N) " + repeated("(1 + ", 200) + "F(N + 1)" + repeated(")", 200) +
                            " #end #declare A = F(0);");
  EXPECT_THAT(scene.messages(), HasSubstr("nested too deeply"));
}

TEST(Depth, LimitIsWhatTheOptionSays) {
  interpreter::EvaluateOptions options;
  options.limits.max_depth = 10;
  constexpr std::string_view kScene = "#macro D(N) #if (N > 1) D(N - 1) #end #end D({})";
  EXPECT_EQ(EvaluatedText(fmt::format(kScene, 10), options).messages(), "");
  EXPECT_THAT(EvaluatedText(fmt::format(kScene, 11), options).messages(), HasSubstr("more than 10"));
}

TEST(Depth, AGreatLimitGetsAGreatStack) {
  SKIP_UNDER_THREAD_SANITIZER();
  interpreter::EvaluateOptions options;
  options.limits.max_depth = 100'000;
  const EvaluatedText scene("#macro S(N) #if (N < 1) 0 #else (1 + S(N - 1)) #end #end #debug str(S(90000), 0, 0)",
                            options);
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "90000");
}

TEST(Depth, AnImpossibleLimitIsAnError) {
  interpreter::EvaluateOptions options;
  options.limits.max_depth = std::size_t{1} << 45;
  EXPECT_THAT(EvaluatedText("sphere { 0, 1 }", options).messages(), HasSubstr("no stack for a depth"));
}

TEST(Depth, ArraysNestedByALoopAreRefused) {
  const EvaluatedText scene(
      "#declare A = array[1] {1} #for (I, 1, 100) #declare B = array[1] #declare B[0] = A; #declare A = B; #end");
  EXPECT_THAT(scene.messages(), HasSubstr("holds others more than 64 deep"));
}

}  // namespace
}  // namespace isl::test
