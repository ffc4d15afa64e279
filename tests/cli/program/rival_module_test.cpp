// The module of the rival solvers where it does not fit the program: the run ends with what to do, wherever the solver
// was named. The program is a copy in a folder of its own, with a module that is none.
#include "tests/cli/program/program_fixture.h"

namespace isl::test {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

constexpr const char* kWhatToDo = "made by the build's target `isl_rivals`";

class RivalModule : public ProgramTest {
 protected:
  RivalModule() {
    fs::create_directories(folder() / "bin");
    fs::create_directories(folder() / "lib/isl");
    fs::copy_file(ISL_PROGRAM, folder() / "bin/isl");
    write("ball.isl", kSmallScene);
    write("marched.isl", "global_settings { solver \"march:0.5px\" }\n" + std::string(kSmallScene));
  }

  [[nodiscard]] ProcessResult run_copy(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command{(folder() / "bin/isl").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, {.folder = folder()});
  }
  [[nodiscard]] ProcessResult by_option() const { return run_copy({"render", "ball.isl", "--solver", "march:0.5px"}); }
  [[nodiscard]] ProcessResult by_scene() const { return run_copy({"render", "marched.isl"}); }

  /// Both ways of naming the solver end with `reason`, and with what to do.
  void expect_refused(const std::string& reason) const {
    const ProcessResult option = by_option();
    EXPECT_EQ(option.exit_code, 3) << option.err;
    EXPECT_THAT(option.err, HasSubstr("--solver: " + reason));
    const ProcessResult scene = by_scene();
    EXPECT_EQ(scene.exit_code, 1) << scene.err;
    EXPECT_THAT(scene.err, HasSubstr("marched.isl:1:"));
    EXPECT_THAT(scene.err, HasSubstr(reason));
    for (const ProcessResult& result : {option, scene}) {
      EXPECT_THAT(result.err, HasSubstr(kWhatToDo));
      EXPECT_THAT(result.err, Not(HasSubstr("internal error")));
    }
  }
};

TEST_F(RivalModule, IsAskedForWhereItIsMissing) { expect_refused("cannot find isl_rivals.so in "); }

TEST_F(RivalModule, IsAskedForWhereItCannotBeLoaded) {
  write("lib/isl/isl_rivals.so", "not a library");
  expect_refused("cannot load isl_rivals.so: ");
}

TEST_F(RivalModule, OfAnotherBuildIsNotUsed) {
  // Any library without the module's functions, or with another stamp, is one.
  fs::copy_file(fs::path(ISL_PROGRAM).parent_path() / "../lib/isl/isl_png.so", folder() / "lib/isl/isl_rivals.so");
  expect_refused((folder() / "bin/../lib/isl/isl_rivals.so").string() + " belongs to another version of the program");
}

}  // namespace
}  // namespace isl::test
