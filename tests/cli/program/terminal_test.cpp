// A terminal obeys nothing that a scene, a file's name or an argument contains: escape sequences, C1 controls
// and marks of bidirectional text are shown. Documents and files have them as they are.
#include "tests/cli/program/program_fixture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace isl::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Clears the screen, turns the rest of the line around, and begins a C1 sequence.
constexpr std::string_view kEvil = "E\x1b[2J\xE2\x80\xAE\xC2\x9B\x33mx";
constexpr std::string_view kShown = "E\\x1b[2J\\u202e\\x9b3mx";

/// True if a terminal would obey a part of the text. Our own styles are taken out first.
bool has_control(std::string text) {
  for (const std::string_view style :
       {"\x1b[1m", "\x1b[1;31m", "\x1b[1;35m", "\x1b[1;36m", "\x1b[0m", "\x1b[K", "\r"}) {
    for (std::size_t at = text.find(style); at != std::string::npos; at = text.find(style))
      text.erase(at, style.size());
  }
  return text.find_first_of(std::string_view("\x1b\x07\x08\x7f\0", 5)) != std::string::npos ||
         text.find("\xC2\x9B") != std::string::npos || text.find("\xE2\x80\xAE") != std::string::npos;
}

class Terminal : public ProgramTest {
 protected:
  /// Runs the command with terminals and with pipes; expects that neither gets a control. Returns what the pipes got.
  ProcessResult expect_visible(const std::vector<std::string>& arguments) {
    const std::string line = fmt::format("isl {}", fmt::join(arguments, " "));
    const ProcessResult seen = run(arguments, {.output = ProcessOptions::Output::terminal, .err_terminal = true});
    EXPECT_FALSE(has_control(seen.out)) << line << "\n" << seen.out;
    EXPECT_FALSE(has_control(seen.err)) << line << "\n" << seen.err;
    ProcessResult piped = run(arguments);
    EXPECT_FALSE(has_control(piped.out)) << line << "\n" << piped.out;
    EXPECT_FALSE(has_control(piped.err)) << line << "\n" << piped.err;
    return piped;
  }
};

TEST_F(Terminal, TheTextOfASceneIsVisible) {
  write("a.isl",
        fmt::format("{}#debug \"{}\\a\\n\"\n#warning \"{}\"\n#render \"{}\"\n", kSmallScene, kEvil, kEvil, kEvil));
  const ProcessResult result = expect_visible({"check", "a.isl"});
  EXPECT_THAT(result.err, StartsWith(fmt::format("{}\\x07\n{}", kShown, kShown)));
  EXPECT_THAT(result.err, HasSubstr(fmt::format("warning: {}\n", kShown)));
  write("a.isl",
        fmt::format("{}#error \"{}\"", kSmallScene, kEvil));  // a text with fewer letters would pass for binary
  EXPECT_THAT(expect_visible({"check", "a.isl"}).err, HasSubstr(fmt::format("error: {}\n", kShown)));
}

TEST_F(Terminal, AFileGetsTheTextOfASceneAsItIs) {
  write("a.isl", fmt::format("#debug \"{}\\a\\n\" sphere {{ 0, 1 }}", kEvil));
  ProcessOptions options;
  options.folder = folder();
  EXPECT_EQ(run_process({"/bin/sh", "-c", "\"$0\" check a.isl > out 2> err", ISL_PROGRAM}, options).exit_code, 0);
  EXPECT_THAT(read("err"), StartsWith(fmt::format("{}\x07\n", kEvil)));
}

TEST_F(Terminal, NamesOfFilesAreVisible) {
  const std::string scene = fmt::format("{}.isl", kEvil), include = fmt::format("{}.inc", kEvil);
  write(include, "#declare X = 1;");
  write(scene, fmt::format("{}#include \"{}\"\n#warning \"here\"", kSmallScene, include));
  const ProcessResult checked = expect_visible({"check", scene});
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_THAT(checked.out, StartsWith(fmt::format("{}.isl: 1 primitive", kShown)));
  EXPECT_THAT(checked.out, HasSubstr(fmt::format(" {}.inc\n", kShown)));
  EXPECT_THAT(checked.err, HasSubstr(fmt::format("{}.isl:7:1: warning", kShown)));
  EXPECT_THAT(expect_visible({"render", scene, "-s", "8x6"}).err, HasSubstr(fmt::format("isl: {}.png, 8x6", kShown)));
  EXPECT_TRUE(exists(fmt::format("{}.png", kEvil)));
  for (const char* const command : {"plan", "dump", "check"}) expect_visible({command, scene, "--format", "json"});
  for (const char* const stage : {"tokens", "ast", "database", "grid"})
    expect_visible({"dump", scene, "--stage", stage});
  expect_visible({"plan", scene});
  expect_visible({"accuracy", scene, "-s", "8x6", "--setting", "hermite", "--repeats", "1"});
}

TEST_F(Terminal, EchoesOfTheCommandLineAreVisible) {
  write("a.isl", kSmallScene);
  const std::string evil(kEvil);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{evil},
                                             {"--" + evil},
                                             {"check", "a.isl", evil},
                                             {"check", "a.isl", "--" + evil},
                                             {"check", evil + ".isl"},
                                             {"check", evil + ".ini"},
                                             {"check", "a.isl", "-D", evil},
                                             {"check", "a.isl", "--format", evil},
                                             {"check", "a.isl", "--max-turns", evil},
                                             {"check", "a.isl", "--allow-write", evil},
                                             {"check", "a.isl", "--without", evil},
                                             {"dump", "a.isl", "--stage", evil},
                                             {"render", "a.isl", "-o", evil},
                                             {"render", "a.isl", "-o", evil + "/a.png"},
                                             {"render", "a.isl", "-o", evil + ".png", "--stats", evil + ".png"},
                                             {"render", "a.isl", "--solver", evil},
                                             {"render", "a.isl", "--simd", evil},
                                             {"render", "a.isl", "--aov", evil},
                                             {"accuracy", "a.isl", "--setting", evil},
                                             {"+I" + evil}}) {
    const ProcessResult result = expect_visible(arguments);
    EXPECT_NE(result.exit_code, 0) << fmt::format("{}", fmt::join(arguments, " "));
    EXPECT_THAT(result.err, HasSubstr("\\u202e")) << fmt::format("{}", fmt::join(arguments, " "));
  }
}

TEST_F(Terminal, ALineEndInANameBeginsNoLineOfItsOwn) {
  const ProcessResult result = run({"check", "a\nisl: error: fake"});
  EXPECT_THAT(run({"fake\nisl: error: fake"}).err, testing::Not(HasSubstr("\nisl: error: fake")));
  write("b\nfake.isl", kSmallScene);
  EXPECT_THAT(run({"check", "b\nfake.isl"}).out, StartsWith("b\\x0afake.isl: "));
}

TEST_F(Terminal, DocumentsHaveTheExactText) {
  write("a.isl", fmt::format("{}#warning \"{}\"\n", kSmallScene, kEvil));
  const nlohmann::json document = nlohmann::json::parse(expect_visible({"check", "a.isl", "--format", "json"}).out);
  EXPECT_EQ(document["diagnostics"][0]["message"], kEvil);
  const std::string scene = fmt::format("{}.isl", kEvil);
  write(scene, kSmallScene);
  EXPECT_EQ(nlohmann::json::parse(run({"check", scene, "--format", "json"}).out)["files"][0]["name"], scene);
}

}  // namespace
}  // namespace isl::test
