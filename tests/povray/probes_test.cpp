// Small scenes that print: both programs must print the same, to the last digit. Each line of a probe is one question
// about an edge of the language. To ask POV-Ray something, add a line to a file in probes/.
#include "renderer/image/image_library.h"
#include "renderer/queries/object_queries.h"
#include "tests/interpreter/evaluated_text.h"
#include "tests/support/source_folder.h"

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

const fs::path kProbes = fs::path(ISL_SOURCE_DIR) / "tests/povray/probes";

std::vector<std::string> probe_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kProbes)) {
    if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool has_povray() {
  static const bool kFound = std::system("povray --version >/dev/null 2>&1") == 0;
  return kFound;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The content of POV-Ray's debug stream, which breaks lines of more than 80 characters.
std::string said_by_povray(const fs::path& scene) {
  const fs::path folder = fs::temp_directory_path() / fs::path("isl_probe_" + scene.stem().string());
  fs::create_directories(folder);
  const std::string command = "cd '" + folder.string() + "' && povray '+I" + scene.string() + "' '+L" +
                              scene.parent_path().string() + "' -D -F +W2 +H2 -GA +GDsaid.txt >/dev/null 2>&1";
  const bool ran = std::system(command.c_str()) == 0;
  std::ifstream file(folder / "said.txt");
  std::ostringstream text;
  text << file.rdbuf();
  fs::remove_all(folder);
  return ran ? text.str() : "povray failed\n";
}

/// Removes the sign of a NaN, which depends on the processor and has no meaning.
std::string without_sign_of_nan(std::string line) {
  for (std::size_t at = line.find("-nan"); at != std::string::npos; at = line.find("-nan")) line.erase(at, 1);
  return line;
}

class Probe : public testing::TestWithParam<std::string> {};

TEST_P(Probe, PrintsWhatPovrayPrints) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  const std::string file = "tests/povray/probes/" + GetParam() + ".pov";
  render::ObjectQueries queries;
  interpreter::EvaluateOptions options;
  options.queries = &queries;
  render::ImageLibrary images({});
  options.images = &images;
  const EvaluatedText ours(EvaluatedText::File{file}, options);
  EXPECT_EQ(ours.sink().error_count(), 0u) << ours.messages();
  const std::vector<std::string> said = lines_of(ours.said());
  const std::vector<std::string> expected = lines_of(said_by_povray(fs::path(ISL_SOURCE_DIR) / file));
  ASSERT_EQ(said.size(), expected.size());
  for (std::size_t i = 0; i < said.size(); ++i)
    EXPECT_EQ(without_sign_of_nan(said[i]), without_sign_of_nan(expected[i])) << "line " << i + 1;
}

INSTANTIATE_TEST_SUITE_P(Povray, Probe, testing::ValuesIn(probe_names()),
                         [](const auto& probe) { return probe.param; });

}  // namespace
}  // namespace isl::test
