// Reading continues after an error, and no mistake is reported twice.
#include "tests/interpreter/evaluated_text.h"

#include <gmock/gmock.h>

namespace isl::test {
namespace {

TEST(Recovery, GoesOnWithTheNextStatement) {
  const EvaluatedText scene("sphere { 0, A } sphere { 0, 1 } sphere { 0, B }");
  EXPECT_EQ(
      scene.messages(),
      "error: undeclared identifier `A`, expected a radius\nerror: undeclared identifier `B`, expected a radius\n");
  EXPECT_EQ(scene.database().solids.size(), 1u);
}

TEST(Recovery, ALoopWithAnErrorIsGivenUp) {
  const EvaluatedText scene("#declare I = 0; #while (I < 10) sphere { 0, A } #declare I = I + 1; #end sphere { 0, 1 }");
  EXPECT_EQ(scene.messages(), "error: undeclared identifier `A`, expected a radius\n");
  EXPECT_EQ(scene.database().solids.size(), 1u);
}

TEST(Recovery, ABranchWithAnErrorIsGivenUpWhereverItStands) {
  EXPECT_EQ(
      EvaluatedText("#if (1) sphere { 0, A } sphere { 0, B } #end sphere { 0, C }").messages(),
      "error: undeclared identifier `A`, expected a radius\nerror: undeclared identifier `C`, expected a radius\n");
  EXPECT_EQ(EvaluatedText("#if (1) sphere { 0, A } sphere { 0, B } #end").messages(),
            "error: undeclared identifier `A`, expected a radius\n");
}

TEST(Recovery, AFailedDeclarationKeepsItsUsesSilent) {
  const EvaluatedText scene(
      "#declare A = B; #declare C = A + 1; sphere { 0, C } #macro M(X) X #end sphere { 0, M(C) } #debug str(C, 0, 0)");
  EXPECT_EQ(scene.messages(), "error: undeclared identifier `B`\n");
}

TEST(Recovery, MistakesOfAllKindsComeInTheOrderOfExecution) {
  EXPECT_EQ(EvaluatedText("sphere { 0, A } box { 0, 1 + } sphere { 0, B } union {").messages(),
            "error: undeclared identifier `A`, expected a radius\n"
            "error: unexpected `}`, expected an expression\n"
            "error: undeclared identifier `B`, expected a radius\n"
            "error: unexpected end of file, expected `}`\n");
}

TEST(Recovery, AMistakeWithinAnUnclosedBlockIsToldInsteadOfTheBrace) {
  EXPECT_EQ(EvaluatedText("sphere { 0, 1 pigment { color rgb x finish { phong 1 } }").messages(),
            "error: unexpected `finish {` in `pigment`\n");
}

TEST(Recovery, AMistakeThatIsExecutedOftenIsToldOnce) {
  EXPECT_EQ(EvaluatedText("#macro A() #if (1) 1 $ #end #end #for (I, 1, 3) #declare B = A(); #end").messages(),
            "error: unexpected character `$`\n");
}

TEST(Recovery, ScopesOfCallsInProgressEndWithAnError) {
  const EvaluatedText scene(
      "#macro M(X) #local L = 1; sphere { X, Missing } #end M(0) #debug str(defined(X) + defined(L), 0, 0)");
  EXPECT_EQ(scene.said(), "0");
}

TEST(Recovery, AnErrorInsideNestedCallsNamesThemAll) {
  const EvaluatedText scene("#macro A() Missing #end #macro B() (1 + A()) #end #declare C = B();");
  ASSERT_EQ(scene.sink().diagnostics().size(), 1u);
  const Diagnostic& diagnostic = scene.sink().diagnostics()[0];
  ASSERT_EQ(diagnostic.chain.size(), 2u);
  EXPECT_EQ(diagnostic.chain[0].name, "A");
  EXPECT_EQ(diagnostic.chain[1].name, "B");
}

}  // namespace
}  // namespace isl::test
