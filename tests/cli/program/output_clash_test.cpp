// No output of a command may be a file that it reads, or another of its outputs, by whatever name.
#include "tests/cli/program/program_fixture.h"

#include <fmt/format.h>

#include <csignal>

namespace isl::test {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class OutputClash : public ProgramTest {
 protected:
  OutputClash() {
    write("ball.isl", kSmallScene);
    fs::create_directory_symlink(".", folder() / "here");
  }

  /// Expects exit code 2 (the command line is wrong) before the scene is read, and that no file has changed.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& message) {
    std::vector<std::string> before = files(), contents;
    std::erase(before, "here");
    for (const std::string& name : before) contents.push_back(read(name));
    const ProcessResult result = run(arguments);
    const std::string line = fmt::format("isl {}", fmt::join(arguments, " "));
    EXPECT_EQ(result.exit_code, 2) << line << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr(message)) << line;
    std::vector<std::string> after = files();
    std::erase(after, "here");
    EXPECT_EQ(after, before) << line;
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(read(before[i]), contents[i]) << line << before[i];
  }
};

TEST_F(OutputClash, NoOutputIsTheScene) {
  write("d.png", kSmallScene);
  write("e.json", kSmallScene);
  fs::create_hard_link(folder() / "ball.isl", folder() / "hard.json");
  fs::create_symlink("ball.isl", folder() / "soft.json");
  expect_refused({"render", "ball.isl", "--stats", "ball.isl"}, "--stats ball.isl: this file is the scene");
  expect_refused({"render", "ball.isl", "--stats", "./here/./ball.isl"}, "this file is the scene");
  expect_refused({"render", "ball.isl", "--stats", "hard.json"}, "--stats hard.json: this file is the scene");
  expect_refused({"render", "ball.isl", "--stats", "soft.json"}, "--stats soft.json: this file is the scene");
  expect_refused({"render", "here/d.png", "-o", "d.png"}, "-o d.png: this file is the scene");
  expect_refused({"render", "d.png"}, "the picture d.png: this file is the scene");
  expect_refused({"accuracy", "e.json", "-o", "e"}, "the report e.json: this file is the scene");
}

TEST_F(OutputClash, NoOutputIsTheFileOfOptions) {
  write("a.ini", "Input_File_Name=ball.isl\n");
  expect_refused({"render", "a.ini", "--stats", "here/a.ini"}, "this file is the file of options");
}

TEST_F(OutputClash, NoOutputIsTheRedirectedScene) {
  const std::vector<std::string> arguments{"/bin/sh", "-c",
                                           std::string(ISL_PROGRAM) + " render - --stats s.json < s.json"};
  write("s.json", kSmallScene);
  ProcessOptions options;
  options.folder = folder();
  const ProcessResult result = run_process(arguments, options);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_THAT(result.err, HasSubstr("--stats s.json: this file is the scene"));
  EXPECT_EQ(read("s.json"), kSmallScene);
}

TEST_F(OutputClash, NoOutputIsAnother) {
  write("old.png", "precious");
  fs::create_hard_link(folder() / "old.png", folder() / "hard.png");
  expect_refused({"render", "ball.isl", "-o", "a.png", "--stats", "here/a.png"},
                 "-o a.png and --stats here/a.png are one file");
  expect_refused({"render", "ball.isl", "-o", "a.png", "-o", "./a.png"}, "-o a.png and -o ./a.png are one file");
  expect_refused({"render", "ball.isl", "-o", "old.png", "-o", "hard.png"}, "are one file");
  expect_refused({"render", "ball.isl", "-o", "a.png", "-o", "a.partial.png"}, "the unfinished picture a.partial.png");
  expect_refused({"render", "ball.isl", "-o", "a.png", "-o", "a.cost.png", "--aov", "cost"}, "the layer a.cost.png");
  expect_refused({"render", "ball.isl", "-o", "a.png", "--stats", "a.cost.png", "--aov", "cost"},
                 "the layer a.cost.png");
}

TEST_F(OutputClash, StandardOutputIsTheFileThatItGoesTo) {
  write("a.png", "precious");
  ProcessOptions to_file{.output = ProcessOptions::Output::file, .output_file = folder() / "a.png"};
  const ProcessResult result = run({"render", "ball.isl", "-s", "8x6", "-o", "png:-", "-o", "a.png"}, to_file);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("are one file"));
  EXPECT_EQ(read("a.png"), "precious");
}

TEST_F(OutputClash, AnInputThatIsAnOutputIsToldAtItsPlace) {
  write("used.png", "precious");
  for (const char* const use :
       {"sphere { 0, 1 pigment { image_map { png \"used.png\" } } }", "#include \"here/used.png\"",
        "#fopen F \"used.png\" read", "sphere { 0, 1 pigment { density_file df3 \"used.png\" } }"}) {
    write("a.isl", std::string(kSmallScene) + use);
    for (const std::vector<std::string>& outputs : {std::vector<std::string>{"-o", "used.png"},
                                                    {"-o", "./here/used.png"},
                                                    {"-o", "x.png", "--stats", "used.png"}}) {
      std::vector<std::string> arguments{"render", "a.isl", "-s", "8x6"};
      arguments.insert(arguments.end(), outputs.begin(), outputs.end());
      const ProcessResult result = run(arguments);
      EXPECT_EQ(result.exit_code, 1) << use << result.err;
      EXPECT_THAT(result.err, HasSubstr("a.isl:6:")) << use;
      EXPECT_THAT(result.err, HasSubstr("this run will replace it (")) << use;
      EXPECT_EQ(read("used.png"), "precious") << use;
      EXPECT_FALSE(exists("x.png"));
    }
  }
}

TEST_F(OutputClash, ASceneMayNotWriteThePicture) {
  write("a.isl", std::string(kSmallScene) + "#fopen F \"a.png\" write #write (F, \"x\")\n");
  const ProcessResult result = run({"render", "a.isl", "-s", "8x6", "--allow-write", "."});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("a.isl:6:10: error: `a.png` may not be written: the picture a.png writes it, too"));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(OutputClash, APictureAndTheFilesOfItsSceneTakeTheirPlacesTogether) {
  write("a.isl", std::string(kSmallScene) + "#fopen F \"x.txt\" write #write (F, \"x\")\n#debug \"read\\n\"\n");
  const ProcessResult result = run({"render", "a.isl", "-s", "2000x1500", "--samples", "64", "--allow-write", "."},
                                   {.when_marked =
                                        [this](int pid) {
                                          EXPECT_FALSE(exists("x.txt"));
                                          kill(pid, SIGINT);
                                        },
                                    .err_marker = "read\n"});
  EXPECT_EQ(exists("x.txt"), exists("a.partial.png")) << "it was interrupted while it was read, or afterwards";
  ASSERT_EQ(run({"render", "a.isl", "-s", "8x6", "--allow-write", "."}).exit_code, 0);
  EXPECT_EQ(read("x.txt"), "x");
  EXPECT_TRUE(exists("a.png"));
}

TEST_F(OutputClash, EveryCommandThatEvaluatesWritesTheFilesOfTheScene) {
  write("a.isl", std::string(kSmallScene) + "#fopen F \"x.txt\" write #write (F, \"x\")\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"check", "a.isl"},
        {"plan", "a.isl"},
        {"dump", "a.isl", "--stage", "database"},
        {"accuracy", "a.isl", "-s", "8x6", "--setting", "hermite", "--repeats", "1"}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--allow-write", "."});
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << command[0] << result.err;
    EXPECT_EQ(read("x.txt"), "x") << command[0];
    fs::remove(folder() / "x.txt");
  }
}

}  // namespace
}  // namespace isl::test
