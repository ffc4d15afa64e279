// A branch at the end of its list takes the list's frame (a tail call). This must not change what `#break` leaves, nor
// the text that follows.
#include "tests/interpreter/evaluated_text.h"

#include <gtest/gtest.h>

namespace isl::test {
namespace {

TEST(Branch, ABreakInTheLastBranchLeavesTheLoop) {
  EXPECT_EQ(EvaluatedText("#for (I, 0, 5) #debug str(I, 0, 0) #if (I = 2) #break #end #end #debug \"!\"").said(),
            "012!");
  EXPECT_EQ(EvaluatedText("#while (1) #if (1) #if (1) #break #end #end #end #debug \"!\"").said(), "!");
}

TEST(Branch, ABreakInTheLastBranchOfACaseLeavesTheSwitch) {
  EXPECT_EQ(EvaluatedText("#switch (1) #case (1) #if (1) #break #end #case (2) #debug \"2\" #end #debug \"!\"").said(),
            "!");
}

TEST(Branch, ABreakInTheLastBranchOfAMacroReturns) {
  EXPECT_EQ(EvaluatedText("#macro M() #if (1) #break #debug \"no\" #end #end M() #debug \"!\"").said(), "!");
}

TEST(Branch, ALoopWhoseBodyEndsInABranchGoesOnWithItsBody) {
  EXPECT_EQ(EvaluatedText("#for (I, 0, 3) #debug \".\" #if (I != 1) #debug str(I, 0, 0) #end #end").said(), ".0..2.3");
}

TEST(Branch, ACaseThatEndsInABranchFallsThrough) {
  EXPECT_EQ(EvaluatedText("#switch (1) #case (1) #if (1) #debug \"1\" #end #case (2) #debug \"2\" #end").said(), "12");
}

}  // namespace
}  // namespace isl::test
