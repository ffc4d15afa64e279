// Results that cannot be written to standard output are an error with exit code 3, whatever the command; streams that
// are closed do not mix with the files of a run.
#include "tests/cli/program/program_fixture.h"

namespace isl::test {
namespace {

using testing::HasSubstr;

using Output = ProcessOptions::Output;

class StandardStreams : public ProgramTest {
 protected:
  StandardStreams() { write("ball.isl", kSmallScene); }
};

const std::vector<std::vector<std::string>>& commands() {
  static const std::vector<std::vector<std::string>> kCommands{
      {"check", "ball.isl"},
      {"check", "ball.isl", "--format", "json"},
      {"library"},
      {"library", "Curve_place", "--format", "json"},
      {"plan", "ball.isl"},
      {"plan", "ball.isl", "--format", "json"},
      {"dump", "ball.isl", "--stage", "ast"},
      {"dump", "ball.isl", "--stage", "database"},
      {"dump", "ball.isl", "--stage", "grid", "--format", "json"},
      {"accuracy", "ball.isl", "-s", "8x6", "--setting", "hermite", "--repeats", "1"},
      {"render", "ball.isl", "-s", "8x6", "--format", "json"},
      {"--help"},
      {"--version"},
      {"help", "render"}};
  return kCommands;
}

TEST_F(StandardStreams, AnOutputThatTakesNothingIsExitCode3) {
  const struct {
    ProcessOptions options;
    const char* reason;
  } cases[] = {{{.output = Output::file, .output_file = "/dev/full"}, "No space left on device"},
               {{.output = Output::unread}, "Broken pipe"},
               {{.output = Output::closed}, "Bad file descriptor"}};
  for (const auto& [options, reason] : cases) {
    for (const std::vector<std::string>& command : commands()) {
      const ProcessResult result = run(command, options);
      EXPECT_EQ(result.exit_code, 3) << command[0] << " " << command.back() << " " << reason;
      EXPECT_THAT(result.err, HasSubstr(std::string("isl: error: cannot write to standard output: ") + reason + "\n"))
          << command[0] << " " << command.back();
    }
  }
}

TEST_F(StandardStreams, ResultsThatArriveAreNoError) {
  for (const std::vector<std::string>& command : commands()) {
    const ProcessResult result = run(command);
    EXPECT_EQ(result.exit_code, 0) << command[0] << result.err;
    EXPECT_NE(result.out, "") << command[0];
  }
}

TEST_F(StandardStreams, AResultLargerThanAPipeArrivesWhole) {
  std::string text(kSmallScene);
  for (int i = 0; i < 3000; ++i) text += "sphere { 0, 1 pigment { rgb <1, 0.5, 0> } }\n";
  write("large.isl", text);
  const ProcessResult result = run({"dump", "large.isl", "--stage", "ast"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_GT(result.out.size(), 200'000u);
  EXPECT_EQ(result.out.back(), '\n');
}

TEST_F(StandardStreams, MessagesDoNotGoIntoAFileThatHasTheNumberOfAClosedStream) {
  write("ball.isl", std::string(kSmallScene) + "#debug \"spoken\"\n#warning \"warned\"\n");
  ASSERT_EQ(run({"render", "ball.isl", "-s", "8x6", "-o", "open.png"}).exit_code, 0);
  const std::string script = "\"$0\" render ball.isl -s 8x6 -o closed.png <&- >&- 2>&-";
  ProcessOptions options;
  options.folder = folder();
  EXPECT_EQ(run_process({"/bin/sh", "-c", script, ISL_PROGRAM}, options).exit_code, 0);
  EXPECT_TRUE(read("closed.png") == read("open.png"));
}

TEST_F(StandardStreams, ASceneFromAClosedStandardInputIsAnError) {
  ProcessOptions options;
  options.folder = folder();
  const ProcessResult result = run_process({"/bin/sh", "-c", "\"$0\" check - <&-", ISL_PROGRAM}, options);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot read `standard input`: Bad file descriptor"));
}

}  // namespace
}  // namespace isl::test
