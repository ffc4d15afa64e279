// Our own contextual words, as listed in language.md, are reserved nowhere: each is tried as a variable, as a macro's
// parameter and as a macro, in one scene that uses the words with their own meanings too.
#include "tests/interpreter/evaluated_text.h"

#include <gtest/gtest.h>

#include <regex>

namespace isl::test {
namespace {

class ContextualWord : public testing::TestWithParam<const char*> {};

TEST_P(ContextualWord, KeepsWorkingAsVariableParameterAndMacro) {
  static const char* const kScene = R"(
    global_settings { assumed_gamma 1 solver "hermite" tolerance "0.05px" }
    #macro Twice(WORD) (2 * WORD) #end
    #macro Grow(WORD) #declare WORD = WORD + 1; #end
    #declare WORD = 20;
    Grow(WORD)
    #declare Sum = Twice(WORD) + WORD;
    #debug concat(str(Sum, 0, 0), " ")
    blob { kernel "gaussian" hardness 4 sphere { 0, WORD } }
    blob { sphere { <WORD, 0, 0>, WORD, 1 } threshold 0.5 }
    #local Array = array[2] { WORD, WORD + 1 }
    #debug concat(str(Array[1] - WORD, 0, 0), " ")
    #undef WORD
    #ifdef (WORD) #error "it is still declared" #end
    #macro WORD(A, B) (A - B) #end
    #debug str(WORD(10, 3), 0, 0)
    blob { kernel "quartic" sphere { 0, WORD(2, 1) } }
  )";
  const EvaluatedText scene(std::regex_replace(std::string(kScene), std::regex("WORD"), GetParam()));
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "63 1 7");
  ASSERT_EQ(scene.database().blobs.size(), 3u);
  EXPECT_EQ(scene.database().blobs[0].components[0].radius_a, 21);
  EXPECT_EQ(scene.database().blobs[1].components[0].a.x, 21);
  EXPECT_EQ(scene.database().blobs[2].components[0].radius_a, 1);
}

INSTANTIATE_TEST_SUITE_P(All, ContextualWord,
                         testing::Values("kernel", "hardness", "solver", "tolerance", "convolution", "skeleton",
                                         "gaussian", "metaball", "soft", "cauchy", "hermite", "paper", "ring", "circle",
                                         "segment", "point", "part", "surface", "field", "potential", "Isl"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace isl::test
