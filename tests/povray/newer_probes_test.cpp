// Small scenes in the words of POV-Ray 3.8, which no distribution carries: what it printed is kept beside each scene
// (newer_probes/README.md). If ISL_POVRAY_38 names its program, it is asked again.
#include "tests/interpreter/evaluated_text.h"
#include "tests/support/source_folder.h"

#include "renderer/image/image_library.h"
#include "renderer/queries/object_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(ISL_SOURCE_DIR) / "tests/povray/newer_probes";

std::vector<std::string> newer_probe_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What the program prints between the lines with which it begins to parse and to count.
std::string said_by(const std::string& program, const fs::path& scene) {
  const fs::path out = fs::temp_directory_path() / ("isl_newer_probe_" + scene.stem().string());
  const std::string command =
      "'" + program + "' '+I" + scene.string() + "' '+O" + out.string() +
      ".png' -D +W2 +H2 +GD -GW 2>&1 | sed -n '/Parsing/,/^----/p' | grep -v '^====\\|^----\\|^$' > '" + out.string() +
      "'";
  const bool ran = std::system(command.c_str()) == 0;
  std::string text = ran ? text_of(out) : "";
  fs::remove(out);
  return text;
}

class NewerProbe : public testing::TestWithParam<std::string> {};

TEST_P(NewerProbe, PrintsWhatPovray38Printed) {
  const std::string file = "tests/povray/newer_probes/" + GetParam() + ".pov";
  const std::string expected = text_of(kFolder / (GetParam() + ".txt"));
  if (const char* const program = std::getenv("ISL_POVRAY_38")) {
    EXPECT_EQ(said_by(program, fs::path(ISL_SOURCE_DIR) / file), expected) << "the recorded text is another";
  }
  render::ObjectQueries queries;
  interpreter::EvaluateOptions options;
  options.queries = &queries;
  render::ImageLibrary images({});
  options.images = &images;
  const EvaluatedText ours(EvaluatedText::File{file}, options);
  EXPECT_EQ(ours.sink().error_count(), 0u) << ours.messages();
  EXPECT_EQ(ours.said(), expected);
}

INSTANTIATE_TEST_SUITE_P(Povray38, NewerProbe, testing::ValuesIn(newer_probe_names()),
                         [](const auto& probe) { return probe.param; });

}  // namespace
}  // namespace isl::test
