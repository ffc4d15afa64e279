// Output of `isl render`: pictures and messages go to files, standard output and terminals, and a full disk is
// reported.
#include "tests/cli/program/program_fixture.h"
#include "tests/support/environment.h"

#include <sys/resource.h>

#include <csignal>
#include <thread>

namespace isl::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

namespace fs = std::filesystem;
using Output = ProcessOptions::Output;

constexpr std::string_view kPngStart = "\x89PNG";

class RenderOutput : public ProgramTest {
 protected:
  RenderOutput() {
    write("ball.isl", kSmallScene);
    fs::create_directory(folder() / "kept");
  }

  /// `isl render ball.isl -s 48x36 …`
  [[nodiscard]] ProcessResult render(std::vector<std::string> options, const ProcessOptions& how = {}) const {
    options.insert(options.begin(), {"render", "ball.isl", "-s", "48x36"});
    return run(options, how);
  }

  // Pictures without room are kept in one of these.
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", "/dev/null/cache"};
  const EnvironmentVariable home_{"HOME", "/dev/null"};
};

/// While this object lives, no file of this process and of those it starts may grow beyond `bytes`.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~SizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST_F(RenderOutput, ToStandardOutputIsTheFileAndNothingElse) {
  write("ball.isl", std::string(kSmallScene) + "#debug \"spoken\\n\"\n#warning \"warned\"\n");
  for (const std::string format : {"png", "exr", "tif", "jpg", "ppm", "hdr"}) {
    const ProcessResult piped = render({"-o", format + ":-"});
    ASSERT_EQ(piped.exit_code, 0) << piped.err;
    ASSERT_EQ(render({"-o", "file." + format}).exit_code, 0);
    EXPECT_TRUE(piped.out == read("file." + format)) << format;
    EXPECT_THAT(piped.err, HasSubstr("spoken"));
    EXPECT_THAT(piped.err, HasSubstr("isl: standard output, 48x36, "));
    fs::remove(folder() / ("file." + format));
  }
  EXPECT_THAT(files(), ElementsAre("ball.isl", "kept"));
}

TEST_F(RenderOutput, ToStandardOutputAndAFileAtOnce) {
  const ProcessResult result = render({"-o", "PNG:-", "-o", "a.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out == read("a.png"));
  EXPECT_EQ(render({"-o", "png:-", "-o", "exr:-"}).exit_code, 2) << "two pictures in one stream";
}

TEST_F(RenderOutput, ATerminalGetsNoPicture) {
  write("ball.isl", "#debug \"evaluated\"\n");
  const ProcessResult result = render({"-o", "png:-"}, {.output = Output::terminal});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("standard output is a terminal"));
  EXPECT_THAT(result.err, Not(HasSubstr("evaluated"))) << "the error is reported before the scene is read";
}

TEST_F(RenderOutput, AReaderThatIsGoneIsAnErrorOfFiles) {
  const ProcessResult result = render({"-o", "png:-", "-o", "a.png"}, {.output = Output::unread});
  EXPECT_EQ(result.exit_code, 3) << "no signal ends it";
  EXPECT_THAT(result.err, HasSubstr("cannot write to standard output: Broken pipe"));
  EXPECT_TRUE(read("a.png").starts_with(kPngStart)) << "the other picture is there all the same";
}

TEST_F(RenderOutput, AFullDiskIsAnErrorOfFiles) {
  const ProcessResult result = render({"-o", "png:-"}, {.output = Output::file, .output_file = "/dev/full"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot write to standard output: No space left on device"));
}

TEST_F(RenderOutput, AClosedStandardOutputIsToldBeforeTheSceneIsRead) {
  write("ball.isl", "#debug \"evaluated\"\n");
  const ProcessResult result = render({"-o", "png:-"}, {.output = Output::closed});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot write to standard output"));
  EXPECT_THAT(result.err, Not(HasSubstr("evaluated")));
}

TEST_F(RenderOutput, WithoutRoomTheOldFilesStay) {
  write("a.png", "precious");
  ProcessResult result;
  {
    const SizeLimit limit(100);
    result = render({"-o", "a.png"});
  }
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot write a.png: File too large"));
  EXPECT_EQ(read("a.png"), "precious");
  EXPECT_THAT(files(), ElementsAre("a.png", "ball.isl", "kept")) << "nothing half-written is left";
}

TEST_F(RenderOutput, AFailureOfOneOutputLeavesTheOthersTheirs) {
  write("a.ppm", "precious");
  ProcessResult result;
  {
    const SizeLimit limit(4000);  // the PNG is smaller than that, the PPM has 5 kB
    result = render({"-o", "a.ppm", "-o", "b.png", "--bits", "8"});
  }
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("a.ppm"));
  EXPECT_EQ(read("a.ppm"), "precious");
  EXPECT_TRUE(read("b.png").starts_with(kPngStart));
}

TEST_F(RenderOutput, APictureWhoseFolderIsGoneIsKeptElsewhere) {
  write("ball.isl", std::string(kSmallScene) + "#debug \"read\\n\"\n");
  write("out/old.txt", "x");
  cache_.set(folder() / "kept");
  const ProcessResult result =
      render({"-o", "out/a.png", "-o", "b.png", "--stats", "out/s.json", "-s", "300x200", "--samples", "64"},
             {.when_marked = [this](int) { fs::remove_all(folder() / "out"); }, .err_marker = "read\n"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("isl: error: cannot write out/a.png: there is no folder out; it is kept as " +
                                    (folder() / "kept/isl/a.png").string()));
  EXPECT_THAT(result.err, HasSubstr("it is kept as " + (folder() / "kept/isl/s.json").string()));
  EXPECT_TRUE(read("kept/isl/a.png") == read("b.png"));
}

TEST_F(RenderOutput, APictureForAFullDiskIsKeptElsewhere) {
  fs::create_directory(folder() / "disk");
  cache_.set(folder() / "disk/cache");
  const EnvironmentVariable temporary("TMPDIR", folder() / "kept");
  // A disk of 64 KiB, which only this shell and its children see.
  const std::string script =
      "mount -t tmpfs -o size=64k none disk || exit 77; echo precious > disk/a.ppm; \"$0\" render ball.isl -s 300x200 "
      "-o disk/a.ppm; "
      "code=$?; ls -A disk; cat disk/a.ppm; exit $code";
  ProcessOptions options;
  options.folder = folder();
  const ProcessResult result = run_process({"/usr/bin/unshare", "-Urm", "/bin/sh", "-c", script, ISL_PROGRAM}, options);
  if (result.exit_code == 77 || result.exit_code == 1) GTEST_SKIP() << "this system lets nobody mount: " << result.err;
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot write disk/a.ppm: No space left on device; it is kept as " +
                                    (folder() / "kept/a.ppm").string()));
  EXPECT_EQ(result.out, "a.ppm\nprecious\n") << "the old file is there, and nothing half-written";
  ASSERT_EQ(render({"-s", "300x200", "-o", "b.ppm"}).exit_code, 0);
  EXPECT_TRUE(read("kept/a.ppm") == read("b.ppm"));
}

TEST_F(RenderOutput, BitsAreThoseAskedFor) {
  ASSERT_EQ(render({"-o", "default.png"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "a.png", "-o", "a.tif", "--bits", "8"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "b.png", "--bits", "16"}).exit_code, 0);
  constexpr std::size_t kDepth = 24;  // PNG: 8 bytes signature, 8 chunk header, 8 width and height, then the bits
  EXPECT_EQ(read("a.png").at(kDepth), 8);
  EXPECT_EQ(read("b.png").at(kDepth), 16);
  EXPECT_TRUE(read("b.png") == read("default.png"));
  EXPECT_EQ(render({"-o", "a.jpg", "--bits", "16"}).exit_code, 2);
}

TEST_F(RenderOutput, AClosingLineTellsWhatWasWritten) {
  for (const bool is_terminal : {false, true}) {
    const ProcessResult result = render({"-o", "a.png"}, {.err_terminal = is_terminal});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, MatchesRegex("isl: a\\.png, 48x36, [0-9]+\\.[0-9][0-9] s\n"));
    EXPECT_EQ(render({"-q"}, {.err_terminal = is_terminal}).err, "");
  }
  EXPECT_THAT(render({"-o", "a.png", "--crop", "8,8,24,16"}).err, StartsWith("isl: a.png, 16x8 of 48x36, "));
  EXPECT_EQ(render({"--format", "json"}).err, "") << "the document contains it";
}

TEST_F(RenderOutput, CtrlCSendsNoPartOfAPictureToStandardOutput) {
  write("ball.isl", std::string(kSmallScene) + "#debug \"tracing\\n\"\n");
  const ProcessResult result = run({"render", "ball.isl", "-s", "3000x2000", "--samples", "256", "-o", "png:-"},
                                   {.when_marked =
                                        [](int pid) {
                                          std::this_thread::sleep_for(std::chrono::milliseconds(700));
                                          kill(pid, SIGINT);
                                        },
                                    .err_marker = "tracing",
                                    .limit = std::chrono::seconds(60)});
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("interrupted; no file was written"));
}

}  // namespace
}  // namespace isl::test
