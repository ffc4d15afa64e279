#include "tests/interpreter/evaluated_text.h"

#include <gmock/gmock.h>

namespace isl::test {
namespace {

using interpreter::EvaluateOptions;
using testing::HasSubstr;

TEST(Options, DefinesAreBoundBeforeTheFirstLine) {
  EvaluateOptions options;
  options.defines = {{"Levels", 4.0}, {"Kernel", std::string("quartic")}};
  const EvaluatedText scene(R"(#ifndef (Levels) #declare Levels = 3; #end #debug concat(str(Levels, 0, 0), Kernel))",
                            options);
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "4quartic");
}

TEST(Options, ClockFrameAndSizeReachTheScene) {
  EvaluateOptions options;
  options.clock = 0.5;
  options.frame = 7;
  options.image_width = 40;
  options.image_height = 30;
  const EvaluatedText scene(
      R"(#debug concat(str(clock, 0, 2), " ", str(frame_number, 0, 0), " ", str(image_width / image_height, 0, 3)))",
      options);
  EXPECT_EQ(scene.said(), "0.50 7 1.333");
}

TEST(Options, ClockAndFrameAreWhatTheOptionsSay) {
  constexpr std::string_view kScene =
      "#debug vstr(5, <clock, clock_on, frame_number, initial_frame, final_frame>, \" \", 0, 1) "
      "#debug vstr(3, <initial_clock, final_clock, clock_delta>, \"/\", 0, 1)";
  EvaluateOptions options;
  options.clock = 0.5;
  options.clock_on = true;
  EXPECT_EQ(EvaluatedText(kScene, options).said(), "0.5 1.0 0.0 0.0 0.00.0/0.0/0.0");
  options.frame = 3;
  EXPECT_EQ(EvaluatedText(kScene, options).said(), "0.5 1.0 3.0 3.0 3.00.5/0.5/0.0");
}

TEST(Options, LenientKeepsANameOfWhatIsNotSupported) {
  EvaluateOptions options;
  options.lenient = true;
  const EvaluatedText scene("#declare Vase = lathe { } union { Vase sphere { 0, 1 } }", options);
  EXPECT_FALSE(scene.sink().has_errors());
  EXPECT_THAT(scene.messages(), HasSubstr("warning: `lathe` is not supported"));
  ASSERT_EQ(scene.database().groups.size(), 2u);
  EXPECT_EQ(scene.database().groups[0].children.size(), 0u) << "an empty group replaces the lathe";
  EXPECT_EQ(scene.database().groups[1].children.size(), 2u);
}

TEST(Options, WithoutLenientWhatIsNotSupportedIsAnError) {
  const EvaluatedText scene("#declare Vase = lathe { } Vase");
  EXPECT_EQ(scene.messages(), "error: `lathe` is not supported\n");
}

TEST(Options, AssumedGammaDefaultsToLinearInTheNewestLanguageOnly) {
  EXPECT_EQ(EvaluatedText("").database().settings.assumed_gamma, 1);
  EXPECT_EQ(EvaluatedText("#version 3.6;").database().settings.assumed_gamma, std::nullopt);
  EXPECT_EQ(EvaluatedText("#version 3.6; global_settings { assumed_gamma 2.2 }").database().settings.assumed_gamma,
            2.2);
}

TEST(Options, OurWordsAreOrdinaryIdentifiersElsewhere) {
  const EvaluatedText scene(R"(
    #declare kernel = 1; #declare hardness = 2; #declare solver = 3; #macro tolerance(A) A #end
    #debug concat(str(kernel, 0, 0), str(hardness, 0, 0), str(solver, 0, 0), str(tolerance(4), 0, 0))
    blob { kernel "gaussian" hardness hardness sphere { 0, kernel } }
    global_settings { solver "exact" tolerance 1e-3 })");
  EXPECT_EQ(scene.messages(), "");
  EXPECT_EQ(scene.said(), "1234");
  EXPECT_EQ(scene.database().kernels.at(0).hardness, 2);
  EXPECT_EQ(scene.database().settings.solver, "exact");
  EXPECT_EQ(scene.database().settings.tolerance, "0.001");
}

}  // namespace
}  // namespace isl::test
