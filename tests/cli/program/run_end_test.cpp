// Runs that are ended from outside: Ctrl-C, SIGTERM, SIGHUP and --max-time, in every phase, and at random moments.
#include "tests/cli/program/program_fixture.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

namespace isl::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Longer than a run takes to see that it is to end: a second, on a machine that is busy with other tests.
constexpr std::chrono::duration<double> kSoon{4};

constexpr std::string_view kView = "camera { location <0, 0, -4> look_at 0 } light_source { -5, 1 }\n";

struct Phase {
  std::string name;
  std::string scene;  ///< takes ten seconds or more, and says "begin" where it begins to
  std::vector<std::string> options;
  bool has_picture = true;
};

std::string begin() { return std::string(kView) + "#debug \"begin\\n\"\n"; }

std::vector<Phase> phases() {
  constexpr std::string_view kSaid = " } #debug \"begin\\n\"";
  const std::string threads =
      "#for (I, 1, 4e5) cylinder { <rand(R), rand(R), rand(R)> * 99, <rand(R), rand(R), rand(R)> * 99, rand(R), 1 } "
      "#end";
  return {
      {"a loop", begin() + "#while (1) #end", {"--max-turns", "1e18"}, false},
      {"a function",
       begin() + "#declare F = function { sum(I, 1, 1e9, sum(J, 1, 1e9, x)) } #declare A = F(1, 1, 1);",
       {"--max-turns", "1e18"},
       false},
      {"inside",
       begin() + "#declare U = sphere { 0, 1 } #for (I, 1, 60) #declare U = union { object { U } object { U } } #end "
                 "#declare A = inside(U, 0.9);",
       {"--max-turns", "1e18"},
       false},
      {"compiling",
       std::string(kView) + "#declare R = seed(1); blob { threshold 1 " + threads + kSaid.data(),
       {},
       true},
      {"tracing",
       std::string(kView) +
           "#declare R = seed(1); blob { threshold 0.9 #for (I, 1, 300) sphere { <rand(R), rand(R), 0>, 1, 0.1 } #end" +
           kSaid.data(),
       {"-s", "4000x3000", "--samples", "4096"},
       true},
      {"patterns", begin() + "sphere { 0, 1 pigment { mandel 4000000000 } }", {"--max-turns", "1e18"}, true},
      {"nested maps",
       begin() +
           "#declare P = pigment { gradient x } #for (I, 1, 60) #declare P = pigment { average pigment_map { [1 P] "
           "[1 P] } } #end sphere { 0, 1 pigment { P } }",
       {"--max-turns", "1e18"},
       true},
  };
}

class RunEnd : public ProgramTest {
 protected:
  /// Renders a scene that says "begin", and sends the signal a moment later.
  ProcessResult end(const Phase& phase, int signal, milliseconds after) {
    write("scene.isl", phase.scene);
    std::vector<std::string> command{"render", "scene.isl", "-s", "64x48", "-o", "a.png"};
    command.insert(command.end(), phase.options.begin(), phase.options.end());
    std::chrono::steady_clock::time_point sent{};
    ProcessOptions options;
    options.when_marked = [&](int pid) {
      std::this_thread::sleep_for(after);
      sent = std::chrono::steady_clock::now();
      kill(pid, signal);
    };
    options.err_marker = "begin";
    ProcessResult result = run(command, options);
    EXPECT_LT(std::chrono::steady_clock::now() - sent, kSoon) << phase.name;
    return result;
  }

  void expect_partial(const Phase& phase, const ProcessResult& result, std::string_view said) {
    EXPECT_THAT(result.err, HasSubstr(said)) << phase.name;
    EXPECT_FALSE(exists("a.png")) << phase.name;
    EXPECT_EQ(exists("a.partial.png"), phase.has_picture) << phase.name << "\n" << result.err;
    if (phase.has_picture) {
      EXPECT_THAT(read("a.partial.png"), HasSubstr("isl:Partial")) << phase.name;
      EXPECT_THAT(read("a.partial.png"), HasSubstr(std::string(said) + "; ")) << phase.name;
    }
    std::filesystem::remove(folder() / "a.partial.png");
  }
};

TEST_F(RunEnd, CtrlCEndsEveryPhaseWithTheFinishedPart) {
  for (const Phase& phase : phases()) {
    const ProcessResult result = end(phase, SIGINT, milliseconds(300));
    EXPECT_EQ(result.exit_code, 130) << phase.name << "\n" << result.err;
    expect_partial(phase, result, "interrupted");
  }
}

TEST_F(RunEnd, ASignalOfTheSystemEndsWithTheFinishedPartAndTellsQueuesToTryAgain) {
  for (const int signal : {SIGTERM, SIGHUP}) {
    for (const Phase& phase : phases()) {
      const ProcessResult result = end(phase, signal, milliseconds(100));
      EXPECT_EQ(result.exit_code, 75) << phase.name << "\n" << result.err;
      expect_partial(phase, result, "ended by a signal");
    }
  }
}

TEST_F(RunEnd, TheTimeAllowedEndsEveryPhaseWithTheFinishedPart) {
  for (const Phase& phase : phases()) {
    write("scene.isl", phase.scene);
    std::vector<std::string> command{"render", "scene.isl", "-s", "64x48", "-o", "a.png", "--max-time", "1"};
    command.insert(command.end(), phase.options.begin(), phase.options.end());
    const ProcessResult result = run(command);
    EXPECT_EQ(result.exit_code, 75) << phase.name << "\n" << result.err;
    EXPECT_LT(result.seconds, std::chrono::seconds(1) + kSoon) << phase.name;
    expect_partial(phase, result, "the time of `--max-time` is over");
  }
}

TEST_F(RunEnd, ARunWithinItsTimeKnowsNothingOfIt) {
  write("scene.isl", kSmallScene);
  const ProcessResult result = run({"render", "scene.isl", "-s", "16x12", "-o", "a.png", "--max-time", "100"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(read("a.png"), testing::Not(HasSubstr("isl:Partial")));
  EXPECT_EQ(run({"check", "scene.isl", "--max-time", "0"}).exit_code, 75);
  EXPECT_EQ(run({"check", "scene.isl", "--max-time", "-1"}).exit_code, 2);
}

TEST_F(RunEnd, WaitingForStandardInputEnds) {
  const std::filesystem::path pipe = folder() / "pipe";
  ASSERT_EQ(run_process({"/usr/bin/mkfifo", pipe.string()}).exit_code, 0);
  // The shell opens the pipe for reading and writing, so that its end never comes.
  const ProcessResult result = run_process(
      {"/bin/sh", "-c", fmt::format("exec '{}' check - --max-time 0.5 <> '{}'", ISL_PROGRAM, pipe.string())});
  EXPECT_EQ(result.exit_code, 75) << result.err;
  EXPECT_LT(result.seconds, kSoon);
}

TEST_F(RunEnd, SignalsThatWereIgnoredStayIgnored) {
  write("scene.isl", std::string(kSmallScene) + "#debug \"begin\\n\"");
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    const auto before = std::signal(signal, SIG_IGN);
    const ProcessResult result = run({"render", "scene.isl", "-s", "300x200", "--samples", "64", "-o", "a.png"},
                                     {.when_marked = [&](int pid) { kill(pid, signal); }, .err_marker = "begin"});
    std::signal(signal, before);
    EXPECT_EQ(result.exit_code, 0) << signal << "\n" << result.err;
    EXPECT_TRUE(exists("a.png"));
  }
}

/// Each signal comes at a moment of its own; whatever was there is whole afterwards, the old picture or the new one.
TEST_F(RunEnd, AtAnyMomentEveryFileIsWhole) {
  const char* const asked = std::getenv("ISL_SIGNALS");
  const int count = asked != nullptr ? std::atoi(asked) : 20;
  const Phase phase{"signals",
                    begin() +
                        "#declare R = seed(1); blob { threshold 1 #for (I, 1, 3000) sphere { <rand(R), rand(R), "
                        "rand(R)> * 2 - 1, 0.1, 1 } #end pigment { bozo } }",
                    {"-s", "320x240"}};
  write("scene.isl", phase.scene);
  const std::vector<std::string> command{"render", "scene.isl", "-s", "320x240", "-o", "a.png"};
  const ProcessResult whole = run(command);
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const std::string picture = read("a.png");
  const auto is_whole = [](const std::string& file) {
    return file.starts_with("\x89PNG") && file.size() > 12 && file.substr(file.size() - 8, 4) == "IEND";
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moment(0, 1.1 * whole.seconds.count());
  for (int i = 0; i < count; ++i) {
    const int signal = std::array{SIGKILL, SIGTERM, SIGINT, SIGHUP}[static_cast<std::size_t>(i) % 4];
    const std::chrono::duration<double> after(moment(random));
    std::filesystem::remove(folder() / "a.partial.png");
    write("a.png", "old");
    const ProcessResult result = run(command, {.when_marked = [&](int pid) {
                                       std::this_thread::sleep_for(after);
                                       kill(pid, signal);
                                     }});
    const std::string where = fmt::format("signal {} after {} s: {}", signal, after.count(), result.err);
    const std::string left = read("a.png");
    if (result.exit_code == 0) {
      EXPECT_EQ(left, picture) << where;
      continue;
    }
    // Before the program catches signals, they end it at once.
    const int expected = signal == SIGKILL ? 128 + SIGKILL : signal == SIGINT ? 130 : 75;
    EXPECT_THAT(result.exit_code, testing::AnyOf(expected, 128 + signal)) << where;
    EXPECT_TRUE(left == "old" || (signal == SIGKILL && left == picture)) << where;
    if (exists("a.partial.png")) {
      EXPECT_TRUE(is_whole(read("a.partial.png"))) << where;
    }
  }
}

}  // namespace
}  // namespace isl::test
