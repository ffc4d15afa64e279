// .ini files given as scenes on the command line.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class IniCommand : public ProgramTest {
 protected:
  IniCommand() { write("ball.pov", kSmallScene); }
};

TEST_F(IniCommand, RendersWhatTheFileSays) {
  write("ball.ini", "; a ball\nInput_File_Name=ball.pov\n+W48 +H36\nOutput_File_Type=P\n[big]\nWidth=96\n");
  EXPECT_EQ(run({"render", "ball.ini"}).exit_code, 0);
  EXPECT_THAT(read("ball.ppm").substr(0, 40), HasSubstr("48 36"));
  EXPECT_EQ(run({"render", "ball.ini[BIG]"}).exit_code, 0);
  EXPECT_THAT(read("ball.ppm").substr(0, 40), HasSubstr("96 36"));
  EXPECT_EQ(run({"render", "ball.ini[BIG]", "-s", "12x9", "-o", "x.ppm"}).exit_code, 0);
  EXPECT_THAT(read("x.ppm").substr(0, 40), HasSubstr("12 9"));
}

TEST_F(IniCommand, TellsWithFileAndLineWhatItLeavesOut) {
  write("ball.ini", "Input_File_Name=ball.pov\nPause_When_Done=off\n");
  const ProcessResult result = run({"check", "ball.ini"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("ball.ini:2:1: warning: `pause_when_done` has no counterpart here; it is ignored"));
  EXPECT_THAT(result.out, HasSubstr("ball.pov: 1 primitive"));
}

TEST_F(IniCommand, RefusesMistakesOfTheFileAsThoseOfTheCommandLine) {
  write("ball.ini", "Input_File_Name=ball.pov\nWidht=3\n");
  const ProcessResult result = run({"render", "ball.ini"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("ball.ini:2:1: error: POV-Ray has no setting `Widht`"));
  EXPECT_FALSE(exists("ball.png"));
  const json document = json::parse(run({"check", "ball.ini", "--format", "json"}).out);
  EXPECT_EQ(document["diagnostics"][0]["severity"], "error");
}

TEST_F(IniCommand, NamesFilesThatAreMissing) {
  EXPECT_EQ(run({"check", "none.ini"}).exit_code, 3);
  EXPECT_THAT(run({"check", "none.ini"}).err, HasSubstr("cannot read `none.ini`"));
  write("a.ini", "Input_File_Name=none.pov\n");
  EXPECT_THAT(run({"check", "a.ini"}).err, HasSubstr("a.ini:1:1: error: cannot find the scene `none.pov`"));
  write("a.ini", "Width=3\n");
  EXPECT_THAT(run({"check", "a.ini"}).err, HasSubstr("names no scene"));
}

TEST_F(IniCommand, FindsTheSceneWhereTheCommandIsGivenElseBesideTheFile) {
  write("sub/a.ini", "Input_File_Name=ball.pov\n");
  EXPECT_THAT(run({"check", "sub/a.ini"}).out, testing::StartsWith("ball.pov: 1 primitive"));
  write("sub/ball.pov", std::string(kSmallScene) + "sphere { 3, 1 }");
  EXPECT_THAT(run({"check", "sub/a.ini"}).out, testing::StartsWith("ball.pov: 1 primitive")) << "as POV-Ray";
  write("sub/near.pov", kSmallScene);
  write("sub/a.ini", "Input_File_Name=near\n");
  EXPECT_THAT(run({"check", "sub/a.ini"}).out, testing::StartsWith("sub/near.pov: 1 primitive"));
}

TEST_F(IniCommand, RendersOneFrameOfAnAnimation) {
  write("turn.pov",
        std::string(kSmallScene) +
            "#debug concat(\"frame \", str(frame_number, 0, 0), \" of \", str(final_frame, 0, 0), \" clock \", "
            "str(clock, 0, 2), \" delta \", str(clock_delta, 0, 2), \"\\n\")");
  write("turn.ini", "Input_File_Name=turn.pov\nFinal_Frame=11\nWidth=12\nHeight=9\n");
  const ProcessResult first = run({"render", "turn.ini"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.err, HasSubstr("turn.ini:2:1: note: frame 1 of 1 to 11 is rendered"));
  EXPECT_THAT(first.err, HasSubstr("frame 1 of 11 clock 0.00 delta 0.10"));
  EXPECT_TRUE(exists("turn01.png"));
  const ProcessResult sixth = run({"render", "turn.ini", "--frame", "6"});
  EXPECT_THAT(sixth.err, HasSubstr("frame 6 of 11 clock 0.50 delta 0.10"));
  EXPECT_THAT(sixth.err, Not(HasSubstr("note")));
  EXPECT_TRUE(exists("turn06.png"));
}

TEST_F(IniCommand, LeavesThePictureTheSameAsTheOptions) {
  write("ball.ini", "Input_File_Name=ball.pov\nWidth=24\nHeight=18\nAntialias=on\nAntialias_Threshold=0.2\n");
  EXPECT_EQ(run({"render", "ball.ini", "-o", "a.png"}).exit_code, 0);
  EXPECT_EQ(run({"render", "ball.pov", "-s", "24x18", "--aa", "0.2", "-o", "b.png"}).exit_code, 0);
  EXPECT_EQ(read("a.png"), read("b.png")) << "metadata included";
}

}  // namespace
}  // namespace isl::test
