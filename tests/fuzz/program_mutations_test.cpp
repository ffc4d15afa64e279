// Mutated scenes through the built program, as a user runs it. `isl check` and a tiny `isl render` must end with a
// documented exit code and never by a signal, every error must have a place, and a picture must exist exactly if the
// exit code says so. ISL_PROGRAM_MUTATIONS sets the number of scenes.
#include "tests/cli/program/program_fixture.h"
#include "tests/fuzz/mutated_scenes.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace isl::test {
namespace {

constexpr int kDone = 0, kSceneError = 1;

class ProgramMutations : public ProgramTest {
 protected:
  /// `isl command… scene.pov` with limits that keep it short.
  [[nodiscard]] ProcessResult run_on(const MutatedScenes& scenes, std::vector<std::string> command) const {
    for (const char* const option : {"scene.pov", "--max-depth", "100", "--max-turns", "20000", "--max-primitives",
                                     "2000", "--max-memory", "256M", "--max-include-depth", "8"}) {
      command.emplace_back(option);
    }
    command.insert(command.end(), {"-I", scenes.origin().parent_path()});
    for (const auto& folder : scenes.search_path()) command.insert(command.end(), {"-I", folder});
    return run(std::move(command), {.limit = std::chrono::seconds(60)});
  }
};

/// The lines that report errors without a place: `error: …` instead of `scene.pov:3:1: error: …`.
std::string errors_without_place(const std::string& messages) {
  std::string found;
  std::stringstream lines(messages);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("error: ")) found += line + "\n";
  }
  return found;
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(ProgramMutations, EndWithinTheContract) {
  MutatedScenes scenes;
  const unsigned long count = std::stoul(setting("ISL_PROGRAM_MUTATIONS", "150"));
  unsigned long accepted = 0, rendered = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::string text = scenes.next();
    const std::string about = fmt::format("scene {}, made from {}:\n{}", i, scenes.origin().string(), text);
    write("scene.pov", text);
    std::filesystem::remove(folder() / "picture.png");

    const ProcessResult check = run_on(scenes, {"check"});
    EXPECT_TRUE(check.exit_code == kDone || check.exit_code == kSceneError) << check.exit_code << ", " << about;
    EXPECT_EQ(check.exit_code == kSceneError, count_of(check.err, ": error: ") > 0) << check.err << about;
    EXPECT_EQ(errors_without_place(check.err), "") << about;
    accepted += check.exit_code == kDone;

    const ProcessResult render =
        run_on(scenes, {"render", "-s", "4x3", "-t", "1", "--samples", "1", "-o", "picture.png"});
    EXPECT_TRUE(render.exit_code == kDone || render.exit_code == kSceneError) << render.exit_code << ", " << about;
    EXPECT_EQ(render.exit_code == kSceneError, count_of(render.err, ": error: ") > 0) << render.err << about;
    EXPECT_EQ(errors_without_place(render.err), "") << about;
    EXPECT_EQ(render.exit_code == kDone, exists("picture.png")) << render.exit_code << ", " << about;
    EXPECT_LE(files().size(), 2u) << "more than the scene and its picture, " << about;
    EXPECT_EQ(check.exit_code, render.exit_code) << "check refuses what render refuses, " << about;
    rendered += render.exit_code == kDone;
  }
  fmt::print("{} scenes: {} accepted, {} rendered\n", count, accepted, rendered);
  EXPECT_GT(accepted, count / 20);
  EXPECT_GT(rendered, count / 20);
}

}  // namespace
}  // namespace isl::test
